#include "tests/app/tour/Screens.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QPixmap>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <QTimer>
#include <cstdio>

namespace sagara::tour {
namespace {

constexpr const char* kPalettes[] = {"day", "dusk", "night"};
constexpr int kSettle_ms = 700;  ///< for the 3D views to draw in another size

}  // namespace

void Screens::settle() { QTest::qWait(kSettle_ms); }

void Screens::keep(const QString& name) {
    std::printf("  %s\n", qPrintable(name));
    std::fflush(stdout);
    if (m_look.folder.empty()) return;
    const QSize size = m_station.size();
    const ui::PaletteName colours = m_station.colours();
    for (const QSize& wanted : m_look.sizes) {
        m_station.resize(wanted);
        for (const ui::PaletteName palette : m_look.palettes) {
            m_station.setColours(palette);
            settle();
            const QString file = QStringLiteral("%1/%2-%3x%4-%5.png")
                                     .arg(QString::fromStdString(m_look.folder.string()), name)
                                     .arg(wanted.width())
                                     .arg(wanted.height())
                                     .arg(QString::fromLatin1(kPalettes[static_cast<int>(palette)]));
            if (m_station.grab().save(file))
                ++m_pictures;
            else
                fail(file + QStringLiteral(" cannot be written"));
        }
    }
    m_station.resize(size);
    m_station.setColours(colours);
}

void Screens::keepWindow(QWidget* window, const QString& name) {
    if (window == nullptr) return fail(name + QStringLiteral(": there is no such window"));
    settle();
    std::printf("  %s\n", qPrintable(name));
    if (m_look.folder.empty()) return;
    const QString file =
        QStringLiteral("%1/%2.png").arg(QString::fromStdString(m_look.folder.string()), name);
    if (window->grab().save(file)) ++m_pictures;
}

void Screens::fail(const QString& what) {
    m_failures += what;
    std::fprintf(stderr, "tour: %s\n", qPrintable(what));
}

QWidget* Screens::find(const QString& objectName) {
    for (QWidget* const window : QApplication::topLevelWidgets()) {
        if (window->objectName() == objectName && window->isVisible()) return window;
        for (auto* const widget : window->findChildren<QWidget*>(objectName)) {
            if (widget->isVisible()) return widget;
            // On a tab that is not in front: brought forward, as a person would.
            for (QWidget* up = widget->parentWidget(); up != nullptr; up = up->parentWidget())
                if (auto* const tabs = qobject_cast<QTabWidget*>(up))
                    for (int i = 0; i < tabs->count(); ++i)
                        if (tabs->widget(i)->isAncestorOf(widget)) tabs->setCurrentIndex(i);
            QApplication::processEvents();
            if (widget->isVisible()) return widget;
        }
    }
    fail(QStringLiteral("%1 is not on the screen (page: %2)")
             .arg(objectName, m_station.page() ? m_station.page()->windowTitle() : QString()));
    return nullptr;
}

void Screens::click(const QString& objectName) {
    QWidget* const widget = find(objectName);
    if (widget == nullptr) return;
    if (!widget->isEnabled()) return fail(objectName + QStringLiteral(" cannot be used now"));
    QTest::mouseClick(widget, Qt::LeftButton);
    QApplication::processEvents();
}

void Screens::type(const QString& objectName, const QString& text) {
    QWidget* const widget = find(objectName);
    if (widget == nullptr) return;
    widget->setFocus();
    if (auto* const line = qobject_cast<QLineEdit*>(widget)) line->selectAll();
    QTest::keyClicks(widget, text);
    QTest::keyClick(widget, Qt::Key_Tab);
}

void Screens::sayYes() {
    QTimer::singleShot(500, &m_station, [] {
        auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (box == nullptr) return;
        QAbstractButton* const yes = box->button(QMessageBox::Yes);
        (yes != nullptr ? yes : box->defaultButton())->click();
    });
}

void Screens::choose(const QString& comboBox, const QString& entry) {
    auto* const box = find<QComboBox>(comboBox);
    if (box == nullptr) return;
    int index = box->findText(entry);
    if (index < 0) index = box->findData(entry);
    if (index < 0) return fail(comboBox + QStringLiteral(" does not offer ") + entry);
    box->setCurrentIndex(index);
    Q_EMIT box->activated(index);
}

bool Screens::waitFor(const QString& what, const std::function<bool()>& done, int atMost_ms) {
    const bool happened = QTest::qWaitFor(done, atMost_ms);
    if (!happened) fail(what + QStringLiteral(" did not happen"));
    return happened;
}

}  // namespace sagara::tour
