#include "ui/help/AboutDialog.h"

#include <QDialogButtonBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace sagara::ui {
namespace {

QTextBrowser* page(const QString& markdown, const QString& name, QWidget* parent) {
    auto* const browser = new QTextBrowser(parent);
    browser->setObjectName(name);
    browser->setOpenExternalLinks(true);
    browser->document()->setDocumentMargin(12.0);
    browser->document()->setMarkdown(markdown, QTextDocument::MarkdownDialectGitHub);
    return browser;
}

QString creditsText(const AboutFacts& facts) {
    QString text;
    for (const AboutFacts::Credit& credit : facts.credits) {
        text += QStringLiteral("### %1\n\n").arg(credit.document);
        for (const QString& line : credit.lines) text += QStringLiteral("- %1\n").arg(line);
        text += QLatin1Char('\n');
    }
    return text.isEmpty() ? AboutDialog::tr("No area or vessel of this installation asks to be named.")
                          : text;
}

}  // namespace

AboutDialog::AboutDialog(const AboutFacts& facts, QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("about"));
    setWindowTitle(tr("About Sagara"));
    resize(760, 560);
    auto* const name = new QLabel(tr("Sagara %1").arg(facts.version), this);
    QFont font = name->font();
    font.setPointSizeF(2.0 * font.pointSizeF());
    font.setBold(true);
    name->setFont(font);
    auto* const words =
        new QLabel(tr("An open ship-handling simulator for maritime schools and navies.\n"
                      "Free software under the GNU General Public License, version 3 or later "
                      "(GPL-3.0-or-later). It comes without any warranty.\nBuild %1")
                       .arg(facts.buildId),
                   this);
    words->setObjectName(QStringLiteral("about-words"));
    words->setWordWrap(true);
    words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* const tabs = new QTabWidget(this);
    tabs->addTab(page(creditsText(facts), QStringLiteral("about-credits"), tabs), tr("Areas and vessels"));
    tabs->addTab(page(facts.attributions, QStringLiteral("about-attributions"), tabs),
                 tr("Everything that is shipped"));
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 16, 20, 16);
    layout->setSpacing(10);
    layout->addWidget(name);
    layout->addWidget(words);
    layout->addWidget(tabs, 1);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
}

QStringList attributionOf(const std::string& documentText) {
    const QJsonValue value = QJsonDocument::fromJson(QByteArray::fromStdString(documentText))
                                 .object()
                                 .value(QStringLiteral("attribution"));
    QStringList lines;
    if (value.isString()) lines.append(value.toString());
    for (const QJsonValue& line : value.toArray()) lines.append(line.toString());
    lines.removeAll(QString());
    return lines;
}

void showAbout(QWidget* parent, const AboutFacts& facts) {
    auto* const dialog = new AboutDialog(facts, parent ? parent->window() : nullptr);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

}  // namespace sagara::ui
