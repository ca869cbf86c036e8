// The debriefing driven as a trainer would, offscreen.
#include "ui/debrief/DebriefPage.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>
#include <cstdlib>

#include "app/files/Files.h"
#include "app/station/DebriefDoor.h"
#include "tests/support/replay/SampleRecording.h"
#include "ui/debrief/PlotStack.h"
#include "ui/debrief/RecordingsPage.h"
#include "ui/debrief/TimeAxis.h"
#include "ui/debrief/Timeline.h"
#include "ui/theme/Theme.h"

namespace sagara::ui {
namespace {

namespace fs = std::filesystem;

core::SimTime seconds(double s) { return {std::llround(1e6 * s)}; }

class Debrief : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        s_folder = fs::temp_directory_path() / ("sagara-debrief-" + std::to_string(::getpid()));
        fs::remove_all(s_folder);
        fs::create_directories(s_folder);
        test::recordLesson(s_folder / "lively.sgr", test::livelyCommands(), 100.0);
    }
    static void TearDownTestSuite() { fs::remove_all(s_folder); }

    void SetUp() override {
        auto store = run::Store::open(s_folder / "data");
        ASSERT_TRUE(store) << store.error();
        m_store = std::move(store).value();
    }
    void TearDown() override {
        m_page.reset();
        m_store.reset();
        fs::remove_all(s_folder / "data");
        fs::remove(s_folder / "lively.sgr.notes.json");
    }

    void open(const fs::path& file, render::Stage* stage = nullptr, QSize size = {1280, 720}) {
        DebriefPorts ports = station::debriefPorts(*m_store, file);
        ports.stage = [stage](const std::shared_ptr<const core::World>& world) {
            if (stage != nullptr) (void)stage->show(world);
            return stage;
        };
        m_page =
            std::make_unique<DebriefPage>(std::move(ports), QString::fromStdString(file.filename().string()));
        m_page->resize(size);
        m_page->show();
        ASSERT_TRUE(QTest::qWaitFor([&] { return m_page->desk() != nullptr || !m_page->trouble().isEmpty(); },
                                    60'000));
        ASSERT_TRUE(m_page->trouble().isEmpty()) << m_page->trouble().toStdString();
        QTest::qWait(200);
    }
    DebriefDesk& desk() { return *m_page->desk(); }
    bool stands() {
        return QTest::qWaitFor([&] { return desk().replay().state().has_value(); }, 10'000);
    }
    template <typename Widget>
    Widget* find(const char* name) {
        auto* const widget = m_page->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }
    void press(const char* name) {
        auto* const button = find<QAbstractButton>(name);
        EXPECT_TRUE(button->isEnabled()) << name;
        button->click();
    }
    void sailTo(double until_s) {
        desk().branch()->setRate(20.0);
        if (!desk().branch()->running()) press("branch-start");
        ASSERT_TRUE(QTest::qWaitFor([&] { return desk().shown() >= seconds(until_s); }, 60'000));
        press("branch-start");
        EXPECT_FALSE(desk().branch()->running());
    }

    static inline fs::path s_folder;
    std::unique_ptr<run::Store> m_store;
    std::unique_ptr<DebriefPage> m_page;
};

TEST_F(Debrief, KeysAndButtonsMoveTheReplayInTime) {
    open(s_folder / "lively.sgr");
    EXPECT_EQ(desk().shown(), seconds(0.0));
    auto* const timeline = find<Timeline>("timeline");
    QTest::keyClick(timeline, Qt::Key_Right);
    EXPECT_EQ(desk().shown(), seconds(1.0));
    QTest::keyClick(timeline, Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_EQ(desk().shown(), seconds(11.0));
    QTest::keyClick(timeline, Qt::Key_Left);
    EXPECT_EQ(desk().shown(), seconds(10.0));
    press("on-10");
    press("back-1");
    EXPECT_EQ(desk().shown(), seconds(19.0));
    QTest::keyClick(timeline, Qt::Key_Right, Qt::ControlModifier);
    EXPECT_GT(desk().shown(), seconds(19.0));
    const core::SimTime mark = desk().shown();
    press("next-mark");
    EXPECT_GT(desk().shown(), mark);
    press("previous-mark");
    EXPECT_EQ(desk().shown(), mark);
    QTest::keyClick(timeline, Qt::Key_End);
    EXPECT_EQ(desk().shown(), seconds(100.0));
    QTest::keyClick(timeline, Qt::Key_Home);
    EXPECT_EQ(desk().shown(), seconds(0.0));
    QTest::keyClick(timeline, Qt::Key_Space);
    EXPECT_TRUE(desk().replay().playing());
    auto* const rate = find<QComboBox>("replay-rate");
    rate->setCurrentIndex(rate->findData(20.0));
    ASSERT_TRUE(QTest::qWaitFor([&] { return desk().shown() > seconds(10.0); }, 10'000));
    press("play");
    EXPECT_FALSE(desk().replay().playing());
}

TEST_F(Debrief, AClickOnAMarkOrInAPlotGoesThere) {
    open(s_folder / "lively.sgr");
    auto* const timeline = find<Timeline>("timeline");
    const auto& marks = timeline->marks();
    const auto weather =
        std::find_if(marks.begin(), marks.end(), [](const auto& m) { return m.kind == MarkKind::Weather; });
    ASSERT_NE(weather, marks.end());
    QTest::mouseClick(timeline, Qt::LeftButton, {}, timeline->placeOf(*weather).toPoint());
    EXPECT_EQ(desk().shown(), seconds(30.0)) << "to the mark itself, not to the pixel";
    const auto bookmark =
        std::find_if(marks.begin(), marks.end(), [](const auto& m) { return m.kind == MarkKind::Note; });
    ASSERT_NE(bookmark, marks.end());
    EXPECT_TRUE(bookmark->text.contains(QStringLiteral("Late to single up")));
    auto* const plots = find<PlotStack>("plots");
    QTest::mouseClick(plots, Qt::LeftButton, {}, QPoint(plots->width() / 2, 30));
    EXPECT_GT(desk().shown(), seconds(40.0));
    EXPECT_LT(desk().shown(), seconds(60.0));
    desk().goTo(seconds(80.0));
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return plots->reading(PlotKind::Rudder).contains(QStringLiteral("order 10.0")); }, 10'000))
        << plots->reading(PlotKind::Rudder).toStdString();
    for (int i = 0; i < kPlotKinds; ++i)
        find<QAction>(("plot-" + std::to_string(i)).c_str())->setChecked(true);
    EXPECT_EQ(plots->shown().size(), static_cast<std::size_t>(kPlotKinds));
    for (int i = 0; i < kPlotKinds; ++i)
        find<QAction>(("plot-" + std::to_string(i)).c_str())->setChecked(false);
    EXPECT_TRUE(plots->shown().empty());
}

TEST_F(Debrief, ANoteIsKeptAndShown) {
    open(s_folder / "lively.sgr");
    desk().goTo(seconds(52.0));
    press("add-note");
    auto* const text = find<QLineEdit>("note-text");
    QTest::keyClicks(text, QStringLiteral("Speed too high here"));
    QTest::keyClick(text, Qt::Key_Return);
    EXPECT_TRUE(fs::exists(s_folder / "lively.sgr.notes.json"));
    const auto& marks = find<Timeline>("timeline")->marks();
    EXPECT_TRUE(std::any_of(marks.begin(), marks.end(), [](const auto& m) {
        return m.kind == MarkKind::Note && m.time == seconds(52.0) &&
               m.text == QStringLiteral("Speed too high here");
    }));
}

TEST_F(Debrief, WhatIfIsSailedComparedAndKept) {
    open(s_folder / "lively.sgr");
    desk().goTo(seconds(60.5));
    ASSERT_TRUE(stands());
    press("sail-from-here");
    ASSERT_TRUE(QTest::qWaitFor([&] { return desk().mode() == DebriefDesk::Mode::Sailing; }, 10'000));
    EXPECT_EQ(desk().branch()->from(), seconds(60.0));
    EXPECT_EQ(desk().branch()->latest()->time(), seconds(60.0));
    desk().goTo(seconds(5.0));
    EXPECT_EQ(desk().shown(), seconds(60.0)) << "what is sailed is not played";
    press("branch-start");
    desk().branch()->give(0, core::PilotOrder{false});
    find<QSlider>("rudder")->setValue(-20);
    sailTo(80.0);
    press("compare");
    EXPECT_EQ(desk().mode(), DebriefDesk::Mode::Comparing);
    auto* const table = find<QTableWidget>("compare-table");
    EXPECT_GT(table->rowCount(), 8);
    EXPECT_EQ(table->item(0, 0)->text(), QStringLiteral("Sailed until"));
    auto* const plots = find<PlotStack>("plots");
    desk().goTo(seconds(75.0));
    EXPECT_TRUE(plots->reading(PlotKind::SpeedOverGround).contains(QStringLiteral("what if")));
    press("sail-on");
    sailTo(85.0);
    press("compare");
    press("compare-close");
    EXPECT_EQ(desk().mode(), DebriefDesk::Mode::Replay);
    EXPECT_EQ(desk().branch(), nullptr);
    EXPECT_TRUE(find<QLabel>("notice")->text().contains(QStringLiteral("is kept as")));
    EXPECT_TRUE(m_page->mayLeave());
}

TEST_F(Debrief, LeavingARunThatIsSailedAsks) {
    open(s_folder / "lively.sgr");
    ASSERT_TRUE(stands());
    press("sail-from-here");
    ASSERT_TRUE(QTest::qWaitFor([&] { return desk().mode() == DebriefDesk::Mode::Sailing; }, 10'000));
    QTimer::singleShot(300, m_page.get(),
                       [&] { find<QMessageBox>("leave-branch")->button(QMessageBox::No)->click(); });
    EXPECT_FALSE(m_page->mayLeave());
    QTimer::singleShot(300, m_page.get(),
                       [&] { find<QMessageBox>("leave-branch")->button(QMessageBox::Yes)->click(); });
    EXPECT_TRUE(m_page->mayLeave());
}

TEST_F(Debrief, FromTheEndOfAFinishedRunNothingCanBeSailed) {
    test::recordLesson(s_folder / "over.sgr", {{500, 0, core::FinishOrder{}}}, 60.0);
    open(s_folder / "over.sgr");
    desk().goTo(desk().replay().end());
    ASSERT_TRUE(stands());
    desk().sailFromHere();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return find<QLabel>("notice")->isVisible() || desk().branch() != nullptr; }, 10'000));
}

TEST_F(Debrief, ADamagedFileSaysSoOnThePage) {
    const fs::path file = s_folder / "broken.sgr";
    ASSERT_FALSE(files::writeTextFile(file, "SGRREC01 and then nothing of use"));
    m_page =
        std::make_unique<DebriefPage>(station::debriefPorts(*m_store, file), QStringLiteral("broken.sgr"));
    m_page->show();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !m_page->trouble().isEmpty(); }, 10'000));
    EXPECT_TRUE(m_page->trouble().contains(QStringLiteral("cannot be opened")));
    bool left = false;
    QObject::connect(m_page.get(), &Page::leaveWanted, m_page.get(), [&] { left = true; });
    press("cancel-opening");
    EXPECT_TRUE(left);
}

TEST_F(Debrief, OpeningCanBeCalledOff) {
    m_page = std::make_unique<DebriefPage>(station::debriefPorts(*m_store, s_folder / "lively.sgr"),
                                           QStringLiteral("lively.sgr"));
    m_page->show();
    bool left = false;
    QObject::connect(m_page.get(), &Page::leaveWanted, m_page.get(), [&] { left = true; });
    press("cancel-opening");
    EXPECT_TRUE(left);
    QTest::qWait(300);
    EXPECT_EQ(m_page->desk(), nullptr);
}

TEST(Recordings, AreListedSearchedAndOpened) {
    std::vector<RecordingEntry> entries(3);
    entries[0].scenario = QStringLiteral("Basic Navigation");
    entries[0].trainee = QStringLiteral("A. Perera");
    entries[0].file = QStringLiteral("/tmp/a.sgr");
    entries[0].score = 88.0;
    entries[0].passed = true;
    entries[1].scenario = QStringLiteral("Anchoring");
    entries[1].file = QStringLiteral("/tmp/b.sgr");
    entries[2].scenario = QStringLiteral("Lost");
    entries[2].present = false;
    QString opened;
    RecordingsPorts ports;
    ports.list = [&] { return entries; };
    ports.open = [&](const QString& file) -> std::optional<QString> {
        opened = file;
        return QStringLiteral("it is damaged");
    };
    RecordingsPage page(ports);
    page.resize(1280, 720);
    page.show();
    auto* const table = page.findChild<QTableWidget*>(QStringLiteral("recordings"));
    auto* const search = page.findChild<QLineEdit*>(QStringLiteral("search-recordings"));
    auto* const open = page.findChild<QPushButton*>(QStringLiteral("debrief"));
    EXPECT_EQ(table->rowCount(), 3);
    search->setText(QStringLiteral("perera basic"));
    ASSERT_EQ(table->rowCount(), 1);
    open->click();
    EXPECT_EQ(opened, QStringLiteral("/tmp/a.sgr"));
    EXPECT_EQ(page.findChild<QLabel*>(QStringLiteral("trouble"))->text(), QStringLiteral("it is damaged"));
    search->setText(QStringLiteral("nowhere"));
    EXPECT_TRUE(page.findChild<QLabel*>(QStringLiteral("empty"))->isVisible());
    EXPECT_FALSE(open->isEnabled());
    search->clear();
    table->selectRow(2);
    EXPECT_FALSE(open->isEnabled()) << "its file is missing";
}

/// SAGARA_UI_PICTURES=DIR leaves a picture of every part in the palettes.
TEST_F(Debrief, Pictures) {
    const char* const folder = std::getenv("SAGARA_UI_PICTURES");
    if (folder == nullptr) GTEST_SKIP() << "no pictures are wanted";
    auto stage = render::Stage::open({SAGARA_ASSETS, render::Preset::Low, true});
    ASSERT_TRUE(stage) << stage.error();
    test::recordBadRun(s_folder / "bad.sgr");
    auto* const application = qobject_cast<QApplication*>(QApplication::instance());
    const auto keep = [&](const QString& name) {
        for (int i = 0; i < 8; ++i) {
            QTest::qWait(150);
            desk().drawViews();
        }
        m_page->grab().save(QString::fromUtf8(folder) + QLatin1Char('/') + name + QStringLiteral(".png"));
    };
    const std::pair<PaletteName, QString> palettes[] = {{PaletteName::Day, QStringLiteral("day")},
                                                        {PaletteName::Night, QStringLiteral("night")},
                                                        {PaletteName::Dusk, QStringLiteral("dusk")}};
    applyTheme(*application, PaletteName::Day);
    open(s_folder / "bad.sgr", stage->get());
    find<QWidget>("fit-run");
    for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
        m_page->resize(size);
        for (const auto& [palette, name] : palettes) {
            if (palette == PaletteName::Dusk && size.width() > 1280) continue;
            applyTheme(*application, palette);
            m_page->setColours(palette);
            desk().goTo(seconds(1041.0));
            ASSERT_TRUE(stands());
            press("fit-run");
            keep(QStringLiteral("replay-%1-%2").arg(name).arg(size.width()));
        }
    }
    m_page->resize(1280, 720);
    applyTheme(*application, PaletteName::Day);
    m_page->setColours(PaletteName::Day);
    desk().goTo(seconds(150.0));
    ASSERT_TRUE(stands());
    press("sail-from-here");
    ASSERT_TRUE(QTest::qWaitFor([&] { return desk().branch() != nullptr; }, 10'000));
    press("branch-start");
    find<QSlider>("rudder")->setValue(-15);
    sailTo(330.0);
    keep(QStringLiteral("sailing-day-1280"));
    press("compare");
    desk().goTo(seconds(300.0));
    keep(QStringLiteral("compare-day-1280"));
    applyTheme(*application, PaletteName::Night);
    m_page->setColours(PaletteName::Night);
    m_page->resize(1920, 1080);
    keep(QStringLiteral("compare-night-1920"));
    press("compare-close");
}

}  // namespace
}  // namespace sagara::ui

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
