#include "tests/app/tour/Tour.h"

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QTest>
#include <QTextBrowser>
#include <QTimer>
#include <set>

#include "app/station/DeskPage.h"
#include "app/station/Doors.h"
#include "app/station/SailPage.h"
#include "core/base/Units.h"
#include "ui/demo/DemoPage.h"
#include "ui/demo/PinPad.h"
#include "ui/trainer/TrainerDesk.h"

namespace sagara::tour {
namespace {

QString s(const char* text) { return QString::fromLatin1(text); }

void home(Screens& screens) {
    screens.sayYes();
    screens.station().leaveAll();
    screens.expect(screens.station().depth() == 1, s("the doors cannot be reached again"));
}

void lookAtPanels(Screens& screens, ui::TrainerDesk& desk) {
    for (const char* panel : {"ship", "events", "traffic", "class", "notes", "wall", "mission"}) {
        desk.showPanel(s(panel));
        screens.keep(QStringLiteral("desk-%1").arg(s(panel)));
    }
}

/// The exercise that is chosen is built aside.
void awaitBriefing(Screens& screens) {
    auto* const words = screens.station().page()->findChild<QTextBrowser*>();
    screens.waitFor(s("the briefing"), [&] { return words != nullptr && words->toPlainText().size() > 200; });
}

/// Start page -> Teach: a lesson sailed by the pilot with the wall on and weather changed, its result,
/// debriefed.
void teach(Screens& screens) {
    screens.keep(s("home"));
    screens.click(s("door-lesson"));
    if (auto* const list = screens.find<QListWidget>(s("scenarios"))) list->setCurrentRow(0);
    screens.click(s("pilot"));
    awaitBriefing(screens);
    screens.keep(s("lesson"));
    screens.click(s("open"));
    auto* const page = dynamic_cast<station::DeskPage*>(screens.station().page());
    if (page == nullptr) return screens.fail(s("the desk did not open"));
    ui::TrainerDesk& desk = *page->desk();
    station::StationRun& run = page->run();

    desk.showPanel(s("wall"));
    screens.choose(s("wall-layout"), s("desk-3x60"));
    if (auto* const placement = screens.find<QComboBox>(s("wall-placement"))) placement->setCurrentIndex(2);
    screens.click(s("wall-start"));
    screens.click(s("start"));
    std::set<std::string> seen;  // a busy machine does not have all of them at once
    const auto allSeen = [&] {
        for (const auto& channel : page->wall().status().channels)
            if (channel.state == "in step" && channel.rate_Hz > 0.0) seen.insert(channel.name);
        return seen.size() == 3;
    };
    screens.waitFor(s("every channel of the wall in step"), allSeen, 120'000);
    desk.showPanel(s("events"));
    if (auto* const wind = screens.find<QDoubleSpinBox>(s("wind"))) wind->setValue(22);
    screens.click(s("apply-weather"));
    screens.waitFor(
        s("a stronger wind"), [&] { return run.latest()->weather.wind.speed_mps > 6.0; }, 120'000);
    screens.choose(s("rate"), s("20x"));
    screens.waitFor(
        s("the first task done"), [&] { return run.latest()->tasks[0].done; }, 120'000);
    lookAtPanels(screens, desk);
    screens.waitFor(
        s("the ship through the entrance"), [&] { return run.latest()->tasks[2].done; }, 240'000);
    desk.showPanel(s("ship"));
    screens.keep(s("desk-under-way"));
    page->endRun();
    screens.waitFor(s("the result"), [&] { return screens.station().page() != page; });
    screens.keep(s("result"));
    screens.click(s("result-debrief"));
    screens.waitFor(s("the replay"), [&] {
        auto* const timeline = screens.station().page()->findChild<QWidget*>(s("timeline"));
        return timeline != nullptr && timeline->isVisible();
    });
    QTest::qWait(2000);
    screens.keep(s("debrief"));
    home(screens);
}

void restOfTeaching(Screens& screens) {
    screens.click(s("door-debrief"));
    screens.keep(s("recordings"));
    home(screens);
    screens.click(s("door-roster"));
    screens.keep(s("roster"));
    if (auto* const tabs = screens.find<QTabWidget>(s("roster-tabs")))
        for (int i = 1; i < tabs->count(); ++i) {
            tabs->setCurrentIndex(i);
            screens.keep(QStringLiteral("roster-%1").arg(i));
        }
    home(screens);
    screens.click(s("door-editor"));
    if (auto* const library = screens.find<QListWidget>(s("library"))) library->setCurrentRow(0);
    screens.keep(s("editor-library"));
    screens.click(s("library-open"));
    if (auto* const sections = screens.find<QListWidget>(s("sections"))) {
        for (int i = 0; i < sections->count(); ++i) {
            sections->setCurrentRow(i);
            QTest::qWait(200);
            screens.keep(QStringLiteral("editor-%1").arg(i + 1));
        }
    }
    home(screens);
}

void train(Screens& screens) {
    screens.click(s("door-train"));
    screens.type(s("trainee"), s("Nimal Perera"));
    awaitBriefing(screens);
    screens.keep(s("watch"));
    screens.click(s("open"));
    auto* const page = dynamic_cast<station::SailPage*>(screens.station().page());
    if (page == nullptr) return screens.fail(s("the console did not open"));
    screens.keep(s("console-briefing"));
    screens.click(s("take-watch"));
    screens.waitFor(s("the watch begins"), [&] { return page->run().latest()->tick > 50; });
    if (auto* const tabs = screens.find<QTabWidget>(s("console-tabs"))) {
        for (int i = 0; i < tabs->count(); ++i) {
            tabs->setCurrentIndex(i);
            QTest::qWait(3000);  // a whole turn of the scanner
            screens.keep(QStringLiteral("console-%1").arg(i + 1));
        }
    }
    screens.click(s("report-port"));
    page->end();
    screens.waitFor(s("the result of the watch"), [&] { return screens.station().page() != page; });
    screens.keep(s("watch-result"));
    home(screens);
}

void practise(Screens& screens) {
    screens.click(s("door-practise"));
    const auto ready = [&] {
        auto* const sail = screens.station().page()->findChild<QPushButton*>(s("set-sail"));
        return sail != nullptr && sail->isEnabled();
    };
    screens.waitFor(s("a lesson to practise"), ready, 60'000);
    screens.keep(s("practise"));
    if (auto* const what = screens.find<QTabWidget>(s("what"))) what->setCurrentIndex(1);
    screens.waitFor(s("a free sail to practise"), ready, 60'000);
    screens.keep(s("practise-free"));
    const auto* const choice = screens.station().page();
    screens.click(s("set-sail"));
    screens.waitFor(
        s("the console of who practises"), [&] { return screens.station().page() != choice; }, 60'000);
    screens.click(s("take-watch"));
    QTest::qWait(3000);
    screens.keep(s("practise-console"));
    screens.sayYes();
    screens.station().leavePage();
    screens.waitFor(s("the result of practice"), [&] {
        return screens.station().page()->findChild<QWidget*>(s("result-line")) != nullptr;
    });
    screens.keep(s("practise-result"));
    home(screens);
}

void vessels(Screens& screens) {
    screens.click(s("door-vessels"));
    screens.keep(s("vessels"));
    // A dialog of its own waits for an answer: answered from the event loop.
    QTimer::singleShot(500, &screens.station(), [&screens] {
        screens.type(s("name"), s("Coaster Lanka"));
        QTest::qWait(500);
        screens.keepWindow(screens.find(s("newVessel")), s("new-vessel"));
        screens.click(s("create"));
    });
    screens.click(s("new"));
    screens.waitFor(s("the new vessel in the list"), [&] {
        auto* const list = screens.station().page()->findChild<QListWidget*>(s("vessels"));
        return list != nullptr && !list->findItems(s("Coaster Lanka"), Qt::MatchContains).isEmpty();
    });
    if (auto* const tabs = screens.find<QTabWidget>(s("tabs"))) {
        for (int i = 0; i < tabs->count(); ++i) {
            tabs->setCurrentIndex(i);
            QTest::qWait(800);
            if (auto* const run = screens.station().page()->findChild<QPushButton*>(s("runTrials"));
                run != nullptr && run->isVisible()) {
                screens.click(s("runTrials"));
                screens.waitFor(
                    s("the trials"),
                    [&] {
                        auto* const checks =
                            screens.station().page()->findChild<QTableWidget*>(s("imoChecks"));
                        return checks != nullptr && checks->rowCount() > 3 && run->isEnabled();
                    },
                    120'000);
            }
            screens.keep(QStringLiteral("vessel-%1").arg(i + 1));
        }
    }
    home(screens);
    screens.click(s("door-database"));
    screens.click(s("checkIntegrity"));
    QTest::qWait(1500);
    screens.keep(s("database"));
    home(screens);
}

void settings(Screens& screens) {
    screens.station().openSettings();
    screens.keep(s("settings"));
    home(screens);
    screens.station().help();
    QTest::qWait(300);
    for (QWidget* const window : QApplication::topLevelWidgets()) {
        if (window == &screens.station() || !window->isVisible()) continue;
        screens.keepWindow(window, s("help"));
        window->close();
    }
}

/// The exhibition, with one visitor who walks away.
void demo(Screens& screens) {
    screens.click(s("door-demo"));
    auto* const page = dynamic_cast<ui::DemoPage*>(screens.station().page());
    if (page == nullptr) return screens.fail(s("the demo did not open"));
    screens.waitFor(s("the demo sails"), [&] { return page->run().latest()->tick > 100; });
    screens.keep(s("demo"));
    QTest::keyClick(page, Qt::Key_A);
    QTest::qWait(1500);
    QTest::keyClick(page, Qt::Key_Right);
    QTest::qWait(1500);
    screens.keep(s("demo-helm"));
    screens.waitFor(
        s("the demo begins again"), [&] { return page->figures().resets >= 1; }, 90'000);
    screens.expect(page->figures().unequal == 0, s("a demo that begins again begins with another State"));
    QTest::keyClick(page, Qt::Key_Q, Qt::ControlModifier | Qt::ShiftModifier);
    QTest::qWait(500);
    screens.keep(s("demo-pin"));
    if (auto* const pad = page->findChild<ui::PinPad*>())
        for (int i = 0; i < 4; ++i) QTest::keyClick(pad, Qt::Key_0);
    screens.waitFor(
        s("the demo left by its PIN"), [&] { return screens.station().page() != page; }, 10'000);
    home(screens);
}

}  // namespace

void walk(Screens& screens, const std::string& only) {
    using Part = void (*)(Screens&);
    const std::pair<const char*, Part> parts[] = {
        {"teach", teach},     {"author", restOfTeaching}, {"train", train}, {"practise", practise},
        {"vessels", vessels}, {"settings", settings},     {"demo", demo}};
    for (const auto& [name, part] : parts)
        if (only.empty() || only == name) part(screens);
}

}  // namespace sagara::tour
