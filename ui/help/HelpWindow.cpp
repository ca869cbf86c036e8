#include "ui/help/HelpWindow.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QTextTable>
#include <QVBoxLayout>

#include "ui/theme/ThemeColours.h"

namespace sagara::ui {
namespace {

constexpr int kTopic = Qt::UserRole;

/// Markdown as Qt reads it has no room between paragraphs, nor borders that suit a dark page.
void dress(QTextDocument& document, const ThemeColours& colours) {
    QTextCursor cursor(&document);
    cursor.beginEditBlock();
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        QTextBlockFormat format = block.blockFormat();
        const int level = format.headingLevel();
        format.setTopMargin(level == 1 ? 0.0 : level > 1 ? 16.0 : 0.0);
        format.setBottomMargin(level > 0 ? 6.0 : block.textList() != nullptr ? 3.0 : 8.0);
        if (QTextCursor(block).currentTable() != nullptr) format.setBottomMargin(0.0);
        format.setLineHeight(125.0, QTextBlockFormat::ProportionalHeight);
        cursor.setPosition(block.position());
        cursor.setBlockFormat(format);
    }
    for (QTextFrame* frame : document.rootFrame()->childFrames()) {
        auto* const table = qobject_cast<QTextTable*>(frame);
        if (table == nullptr) continue;
        QTextTableFormat format = table->format();
        format.setBorder(1.0);
        format.setBorderBrush(colours.line);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderCollapse(true);
        format.setCellPadding(5.0);
        format.setBottomMargin(10.0);
        table->setFormat(format);
    }
    cursor.endEditBlock();
}

}  // namespace

HelpWindow::HelpWindow(HelpBook book, PaletteName palette, QWidget* parent)
    : QDialog(parent),
      m_book(std::move(book)),
      m_palette(palette),
      m_contents(new QListWidget(this)),
      m_search(new QLineEdit(this)),
      m_page(new QTextBrowser(this)),
      m_back(new QPushButton(tr("Back"), this)),
      m_forward(new QPushButton(tr("Forward"), this)) {
    setObjectName(QStringLiteral("help"));
    setWindowTitle(tr("Sagara help"));
    setModal(false);
    resize(920, 640);
    layOut();
    list({});
}

void HelpWindow::layOut() {
    m_contents->setObjectName(QStringLiteral("help-contents"));
    m_contents->setAccessibleName(tr("Contents"));
    m_contents->setWordWrap(true);
    m_contents->setStyleSheet(QStringLiteral("QListWidget::item { padding: 5px 4px; }"));
    m_search->setObjectName(QStringLiteral("help-search"));
    m_search->setPlaceholderText(tr("Search the help"));
    m_search->setClearButtonEnabled(true);
    m_search->setToolTip(tr("Pages with all of these words (Ctrl+F)"));
    m_page->setObjectName(QStringLiteral("help-page"));
    m_page->setOpenLinks(false);
    m_page->setFrameShape(QFrame::NoFrame);
    m_page->document()->setDocumentMargin(20.0);
    m_back->setObjectName(QStringLiteral("help-back"));
    m_back->setToolTip(tr("The page before (Alt+Left)"));
    m_back->setShortcut(QKeySequence(Qt::ALT | Qt::Key_Left));
    m_forward->setObjectName(QStringLiteral("help-forward"));
    m_forward->setToolTip(tr("The page after (Alt+Right)"));
    m_forward->setShortcut(QKeySequence(Qt::ALT | Qt::Key_Right));
    auto* const close = new QPushButton(tr("Close"), this);
    close->setToolTip(tr("Close the help (Esc)"));
    for (QPushButton* button : {m_back, m_forward, close}) button->setAutoDefault(false);

    auto* const bar = new QHBoxLayout;
    bar->addWidget(m_back);
    bar->addWidget(m_forward);
    bar->addStretch();
    bar->addWidget(close);
    auto* const left = new QWidget(this);
    auto* const side = new QVBoxLayout(left);
    side->setContentsMargins(0, 0, 0, 0);
    side->addWidget(m_search);
    side->addWidget(m_contents, 1);
    auto* const split = new QSplitter(this);
    split->addWidget(left);
    split->addWidget(m_page);
    split->setStretchFactor(1, 1);
    split->setSizes({250, 670});
    split->setChildrenCollapsible(false);
    auto* const layout = new QVBoxLayout(this);
    layout->addLayout(bar);
    layout->addWidget(split, 1);

    connect(m_back, &QPushButton::clicked, this, [this] { step(-1); });
    connect(m_forward, &QPushButton::clicked, this, [this] { step(1); });
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    connect(m_search, &QLineEdit::textChanged, this, &HelpWindow::list);
    connect(m_search, &QLineEdit::returnPressed, this, [this] {
        if (m_contents->count() > 0 && m_contents->item(0)->data(kTopic).isValid())
            m_contents->setCurrentRow(0);
    });
    connect(m_contents, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (item != nullptr && item->data(kTopic).isValid()) open(item->data(kTopic).toString());
    });
    connect(m_page, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
        if (url.scheme().isEmpty() && url.path().endsWith(QStringLiteral(".md")))
            open(url.path().chopped(3));
        else
            QDesktopServices::openUrl(url);
    });
    auto* const find = new QShortcut(QKeySequence::Find, this);
    connect(find, &QShortcut::activated, this, [this] {
        m_search->setFocus();
        m_search->selectAll();
    });
}

void HelpWindow::showTopic(const QString& topic) {
    m_search->clear();
    open(topic);
    show();
    raise();
    activateWindow();
}

QString HelpWindow::topic() const { return m_at < 0 ? QString() : m_visited[m_at]; }

void HelpWindow::open(const QString& topic) {
    const bool there = m_book.find(topic) != nullptr;
    m_missing = there ? QString() : topic;
    const QString shown = there ? topic : QStringLiteral("index");
    if (m_at < 0 || m_visited[m_at] != shown) {
        m_visited.resize(m_at + 1);
        m_visited.append(shown);
        ++m_at;
    }
    render();
}

void HelpWindow::step(int by) {
    const auto to = m_at + by;
    if (to < 0 || to >= m_visited.size()) return;
    m_at = to;
    m_missing.clear();
    render();
}

void HelpWindow::list(const QString& words) {
    const QSignalBlocker quiet(m_contents);
    m_contents->clear();
    const auto add = [this](const QString& text, const QString& topic, const QString& tip) {
        auto* const item = new QListWidgetItem(text, m_contents);
        item->setData(kTopic, topic);
        item->setToolTip(tip);
    };
    if (words.simplified().isEmpty()) {
        for (const HelpBook::Page& page : m_book.pages()) add(page.title, page.topic, {});
    } else {
        for (const HelpBook::Found& found : m_book.search(words))
            add(tr("%1\n%2").arg(found.title, found.excerpt), found.topic, found.excerpt);
    }
    if (m_contents->count() == 0) {
        auto* const none = new QListWidgetItem(
            m_book.pages().isEmpty() ? tr("The help pages are missing from this installation.")
                                     : tr("No page has these words. Try fewer or shorter ones."),
            m_contents);
        none->setFlags(Qt::NoItemFlags);
    }
    for (int i = 0; i < m_contents->count(); ++i)
        if (m_contents->item(i)->data(kTopic).toString() == topic() && m_at >= 0)
            m_contents->setCurrentRow(i);
}

void HelpWindow::render() {
    const ThemeColours& colours = themeColours(m_palette);
    const HelpBook::Page* const page = m_book.find(topic());
    QString text = page ? page->text : tr("# Help\n\nThe help pages are missing from this installation.");
    if (!m_missing.isEmpty())
        text.prepend(tr("*There is no help page about “%1” yet; this is the contents.*\n\n").arg(m_missing));
    m_page->document()->setMarkdown(text, QTextDocument::MarkdownDialectGitHub);
    dress(*m_page->document(), colours);
    m_page->moveCursor(QTextCursor::Start);
    m_back->setEnabled(m_at > 0);
    m_forward->setEnabled(m_at + 1 < m_visited.size());
    const QSignalBlocker quiet(m_contents);
    for (int i = 0; i < m_contents->count(); ++i)
        if (m_contents->item(i)->data(kTopic).toString() == topic()) m_contents->setCurrentRow(i);
}

void HelpWindow::setColours(PaletteName palette) {
    m_palette = palette;
    if (m_at >= 0) render();
}

void showHelp(QWidget* parent, const std::filesystem::path& helpFolder, const QString& topic,
              PaletteName palette) {
    QWidget* const window = parent ? parent->window() : nullptr;
    HelpWindow* help =
        window ? window->findChild<HelpWindow*>(QStringLiteral("help"), Qt::FindDirectChildrenOnly) : nullptr;
    if (help == nullptr) {
        help = new HelpWindow(HelpBook(helpFolder), palette, window);
        if (window == nullptr) help->setAttribute(Qt::WA_DeleteOnClose);
    }
    help->setColours(palette);
    help->showTopic(topic);
}

}  // namespace sagara::ui
