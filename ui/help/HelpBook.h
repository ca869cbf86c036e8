#pragma once

#include <QString>
#include <QStringList>
#include <QVector>
#include <filesystem>

namespace sagara::ui {

/// The help pages of a folder, read once. A page is Markdown; its topic is the file's name without ".md".
class HelpBook final {
public:
    struct Page {
        QString topic;
        QString title;
        QString text;
    };
    struct Found {
        QString topic;
        QString title;
        QString excerpt;  ///< the words around the first place, plain
    };

    explicit HelpBook(const std::filesystem::path& folder);

    /// The index first, then in the order the index links them, then the rest by title.
    const QVector<Page>& pages() const { return m_pages; }
    const Page* find(const QString& topic) const;
    /// Pages with all of these words, those with a word in the title first. No words: nothing.
    QVector<Found> search(const QString& words) const;
    /// Links to topics that are not there, "start.md: nowhere"; for the test.
    QStringList brokenLinks() const;

private:
    QVector<Page> m_pages;
};

}  // namespace sagara::ui
