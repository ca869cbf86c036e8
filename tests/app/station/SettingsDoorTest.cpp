// Settings as the station keeps them: in the database, and without one.
#include "app/station/SettingsDoor.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <fstream>

#include "app/station/Frame.h"
#include "app/station/WindowScale.h"
#include "tests/app/station/NoWindow.h"

namespace sagara::station {
namespace {

namespace fs = std::filesystem;

class SettingsDoor : public ::testing::Test {
protected:
    void SetUp() override {
        m_folder = fs::temp_directory_path() / ("sagara-settings-" + std::to_string(::getpid()));
        fs::remove_all(m_folder);
        fs::create_directories(m_folder);
    }
    void TearDown() override { fs::remove_all(m_folder); }
    std::unique_ptr<run::Store> store() {
        auto opened = run::Store::open(m_folder);
        EXPECT_TRUE(opened);
        return std::move(opened).value();
    }
    fs::path m_folder;
};

TEST_F(SettingsDoor, WhatIsSetOnThePageIsThereAtTheNextStart) {
    {
        const auto kept = store();
        ASSERT_NE(kept->database(), nullptr) << kept->trouble();
        NoWindow window(*kept, ui::PaletteName::Dusk);
        ui::BridgeInput input;
        ui::SoundBoard sound;
        const std::unique_ptr<ui::Page> page(settingsPage(window, input, sound, [](ui::PaletteName) {}));
        auto* const pin = page->findChild<QLineEdit*>(QStringLiteral("demo-pin"));
        ASSERT_NE(pin, nullptr);
        EXPECT_EQ(pin->text(), QStringLiteral("0000"));
        pin->selectAll();
        QTest::keyClicks(pin, QStringLiteral("2468"));
        auto* const folder = page->findChild<QLabel*>(QStringLiteral("data-folder"));
        ASSERT_NE(folder, nullptr);
        EXPECT_EQ(folder->text().toStdString(), fs::canonical(m_folder).string());
    }
    const auto kept = store();
    EXPECT_EQ(settingsStore(*kept)->get("demo.pin"), "2468");
    EXPECT_TRUE(settingsStore(*kept)->trouble().isEmpty());
}

TEST(WindowScale, IsTwoOnALargeMonitorThatTheDesktopLeavesAlone) {
    EXPECT_DOUBLE_EQ(monitorScale({1280, 720}, 1.0, 96.0), 1.0);
    EXPECT_DOUBLE_EQ(monitorScale({1920, 1200}, 1.0, 96.0), 1.0);
    EXPECT_DOUBLE_EQ(monitorScale({2560, 1440}, 1.0, 96.0), 1.0);
    EXPECT_DOUBLE_EQ(monitorScale({3840, 2160}, 1.0, 96.0), 2.0);
    EXPECT_DOUBLE_EQ(monitorScale({3440, 1440}, 1.0, 96.0), 1.0);
    EXPECT_DOUBLE_EQ(monitorScale({3840, 2160}, 1.0, 192.0), 1.0);
    EXPECT_DOUBLE_EQ(monitorScale({1920, 1080}, 2.0, 96.0), 1.0);
}

TEST_F(SettingsDoor, WithoutADatabaseSettingsHoldAndThePageSaysHowLong) {
    std::ofstream(m_folder / "sagara.db") << "this is no database, whatever its name says";
    const auto kept = store();
    ASSERT_EQ(kept->database(), nullptr);
    NoWindow window(*kept, ui::PaletteName::Dusk);
    const auto settings = settingsStore(window);
    settings->put("sound.muted", "1");
    EXPECT_EQ(settings->get("sound.muted"), "1");
    EXPECT_FALSE(settings->trouble().isEmpty());
    ui::BridgeInput input;
    ui::SoundBoard sound;
    const std::unique_ptr<ui::Page> page(settingsPage(window, input, sound, [](ui::PaletteName) {}));
    auto* const said = page->findChild<QLabel*>(QStringLiteral("kept"));
    ASSERT_NE(said, nullptr);
    EXPECT_TRUE(said->text().contains(QStringLiteral("until Sagara is closed")));
}

}  // namespace
}  // namespace sagara::station

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    const QApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
