#pragma once

#include <QDialog>
#include <QStringList>

#include "ui/help/HelpBook.h"
#include "ui/theme/PaletteName.h"

class QLineEdit;
class QListWidget;
class QPushButton;
class QTextBrowser;

namespace sagara::ui {

/// The help: contents and search on the left, a page on the right. Stays open beside the window it helps
/// with.
class HelpWindow final : public QDialog {
    Q_OBJECT

public:
    HelpWindow(HelpBook book, PaletteName palette, QWidget* parent = nullptr);

    /// A topic without a page shows the index and says so.
    void showTopic(const QString& topic);
    void setColours(PaletteName palette);
    QString topic() const;

private:
    void layOut();
    void open(const QString& topic);
    void step(int by);
    void list(const QString& words);
    void render();

    HelpBook m_book;
    PaletteName m_palette;
    QStringList m_visited;
    qsizetype m_at = -1;
    QString m_missing;  ///< the topic that was asked for and is not there
    QListWidget* m_contents;
    QLineEdit* m_search;
    QTextBrowser* m_page;
    QPushButton* m_back;
    QPushButton* m_forward;
};

/// Opens the help at a topic, in the one help window of `parent`'s window. `helpFolder` is assets/help.
void showHelp(QWidget* parent, const std::filesystem::path& helpFolder, const QString& topic,
              PaletteName palette);

}  // namespace sagara::ui
