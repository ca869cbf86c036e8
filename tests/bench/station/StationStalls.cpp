// Longest stall of the windows at each step from a lesson to its debriefing (issue 4, section 6: 100 ms).
#include <QAbstractButton>
#include <QApplication>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>
#include <functional>

#include "StallMeter.h"
#include "app/station/DeskPage.h"
#include "app/station/Station.h"
#include "ui/debrief/DebriefDesk.h"
#include "ui/debrief/DebriefPage.h"
#include "ui/trainer/TrainerDesk.h"

namespace sagara::station {
namespace {

class Steps {
public:
    Steps(Station& station, StallMeter& meter) : m_station(station), m_meter(meter) {}

    /// Does something and goes on when it is done, and half a second longer.
    void step(const char* name, const std::function<void()>& act, const std::function<bool()>& done) {
        QTest::qWait(200);
        m_meter.begin();
        act();
        const bool came = QTest::qWaitFor(done, 120'000);
        QTest::qWait(500);
        std::printf("%-28s %s%s\n", name, m_meter.text().c_str(), came ? "" : "  (never done)");
        std::fflush(stdout);
    }
    void press(const char* name) {
        if (auto* const button = m_station.page()->findChild<QPushButton*>(QString::fromLatin1(name)))
            QTest::mouseClick(button, Qt::LeftButton);
    }
    DeskPage* deskPage() { return dynamic_cast<DeskPage*>(m_station.page()); }
    ui::DebriefDesk* debrief() {
        auto* const page = dynamic_cast<ui::DebriefPage*>(m_station.page());
        return page == nullptr ? nullptr : page->desk();
    }

private:
    Station& m_station;
    StallMeter& m_meter;
};

int stalls(double sailed_s) {
    const QTemporaryDir folder;
    auto store = run::Store::open(std::filesystem::path(folder.path().toStdString()));
    if (!store) return std::fprintf(stderr, "%s\n", store.error().c_str()), 2;
    Station station(**store, render::StageOptions{SAGARA_ASSETS, presetOfThisMachine(), true});
    station.resize(1280, 720);
    station.show();
    QTest::qWait(500);
    StallMeter meter;
    Steps s(station, meter);
    const std::size_t home = station.depth();
    s.step(
        "choose a lesson", [&] { s.press("door-lesson"); },
        [&] {
            auto* const open = station.page()->findChild<QPushButton*>(QStringLiteral("open"));
            return station.depth() > home && open != nullptr && open->isEnabled();
        });
    s.step(
        "open its desk", [&] { s.press("open"); }, [&] { return s.deskPage() != nullptr; });
    DeskPage* const desk = s.deskPage();
    if (desk == nullptr) return 1;
    desk->run().give(0, core::PilotOrder{true});
    desk->run().setRate(20.0);
    s.step(
        "sail it", [&] { desk->run().start(); },
        [&] { return desk->run().latest()->time().seconds() > sailed_s; });
    const auto first = desk->run().recording();
    const auto back_s = static_cast<int>(sailed_s) - 1;
    s.step(
        "go back", [&] { Q_EMIT desk->desk()->goBackWanted(back_s); },
        [&] { return desk->run().recording() != first; });
    const auto recording = desk->run().recording();
    desk->run().start();
    QTest::qWait(1000);
    s.step(
        "end it", [&] { desk->endRun(); }, [&] { return s.deskPage() == nullptr; });
    s.step(
        "list the recordings",
        [&] {
            station.leaveAll();
            s.press("door-debrief");
        },
        [&] { return station.depth() > home; });
    s.step(
        "open a recording", [&] { (void)station.openDebrief(recording); },
        [&] { return s.debrief() != nullptr; });
    ui::DebriefDesk* const debrief = s.debrief();
    if (debrief == nullptr) return 1;
    s.step(
        "look at a moment", [&] { debrief->goTo({static_cast<std::int64_t>(0.4e6 * sailed_s)}); },
        [&] { return debrief->replay().state().has_value(); });
    s.step(
        "what if from there", [&] { debrief->sailFromHere(); }, [&] { return debrief->branch() != nullptr; });
    if (debrief->branch() == nullptr) return 1;
    debrief->branch()->setRate(20.0);
    s.step(
        "sail what if", [&] { debrief->branch()->start(); },
        [&] { return debrief->branch()->latest()->time().seconds() > 0.7 * sailed_s; });
    s.step(
        "compare", [&] { debrief->compare(); },
        [&] { return debrief->mode() == ui::DebriefDesk::Mode::Comparing; });
    s.step(
        "file what if", [&] { debrief->endBranch(); }, [&] { return debrief->branch() == nullptr; });
    s.step(
        "leave", [&] { station.leaveAll(); }, [&] { return station.depth() == home; });
    return 0;
}

}  // namespace
}  // namespace sagara::station

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    return sagara::station::stalls(argc > 1 ? std::stod(argv[1]) : 120.0);
}
