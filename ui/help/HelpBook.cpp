#include "ui/help/HelpBook.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <algorithm>

namespace sagara::ui {
namespace {

constexpr int kExcerpt_chars = 90;

QString titleOf(const QString& text, const QString& topic) {
    const QString first = text.section(QLatin1Char('\n'), 0, 0);
    return first.startsWith(QStringLiteral("# ")) ? first.mid(2).trimmed() : topic;
}

QStringList linksOf(const QString& text) {
    static const QRegularExpression link(QStringLiteral("\\]\\(([a-z0-9-]+)\\.md(#[^)]*)?\\)"));
    QStringList topics;
    for (auto it = link.globalMatch(text); it.hasNext();) topics.append(it.next().captured(1));
    return topics;
}

/// Markdown without its signs, on one line.
QString plain(QString text) {
    static const QRegularExpression link(QStringLiteral("\\[([^\\]]*)\\]\\([^)]*\\)"));
    static const QRegularExpression signs(QStringLiteral("[#*`|>_]|-{3,}"));
    return text.replace(link, QStringLiteral("\\1")).remove(signs).simplified();
}

QString excerptOf(const QString& text, const QString& word) {
    const QString line = plain(text);
    const auto at = std::max<qsizetype>(0, line.indexOf(word, 0, Qt::CaseInsensitive));
    auto from = std::max<qsizetype>(0, at - kExcerpt_chars / 3);
    if (from > 0) from = line.indexOf(QLatin1Char(' '), from) + 1;
    QString excerpt = line.mid(from, kExcerpt_chars);
    if (from > 0) excerpt.prepend(QStringLiteral("… "));
    if (from + kExcerpt_chars < line.size()) excerpt.append(QStringLiteral(" …"));
    return excerpt;
}

}  // namespace

HelpBook::HelpBook(const std::filesystem::path& folder) {
    const QDir files(QString::fromStdString(folder.string()));
    for (const QString& name : files.entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name)) {
        QFile file(files.filePath(name));
        if (name == QLatin1String("README.md") || !file.open(QIODevice::ReadOnly)) continue;
        Page page;
        page.topic = name.chopped(3);
        page.text = QString::fromUtf8(file.readAll());
        page.title = titleOf(page.text, page.topic);
        m_pages.append(page);
    }
    const Page* const index = find(QStringLiteral("index"));
    const QStringList order = index ? linksOf(index->text) : QStringList();
    const auto rank = [&](const Page& page) {
        if (page.topic == QLatin1String("index")) return qsizetype{-1};
        const auto at = order.indexOf(page.topic);
        return at < 0 ? order.size() : at;
    };
    std::stable_sort(m_pages.begin(), m_pages.end(), [&](const Page& a, const Page& b) {
        const auto rankA = rank(a), rankB = rank(b);
        return rankA != rankB ? rankA < rankB : a.title.localeAwareCompare(b.title) < 0;
    });
}

const HelpBook::Page* HelpBook::find(const QString& topic) const {
    const auto it =
        std::find_if(m_pages.begin(), m_pages.end(), [&](const Page& page) { return page.topic == topic; });
    return it == m_pages.end() ? nullptr : &*it;
}

QVector<HelpBook::Found> HelpBook::search(const QString& words) const {
    const QStringList wanted = words.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    QVector<Found> inTitle, inText;
    if (wanted.isEmpty()) return inText;
    for (const Page& page : m_pages) {
        const auto has = [](const QString& text) {
            return [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); };
        };
        if (!std::all_of(wanted.begin(), wanted.end(), has(page.text))) continue;
        const bool title = std::any_of(wanted.begin(), wanted.end(), has(page.title));
        (title ? inTitle : inText).append({page.topic, page.title, excerptOf(page.text, wanted.first())});
    }
    return inTitle + inText;
}

QStringList HelpBook::brokenLinks() const {
    QStringList broken;
    for (const Page& page : m_pages)
        for (const QString& topic : linksOf(page.text))
            if (find(topic) == nullptr) broken.append(QStringLiteral("%1.md: %2").arg(page.topic, topic));
    return broken;
}

}  // namespace sagara::ui
