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

namespace sagara::station {
namespace {

namespace fs = std::filesystem;

class Window final : public Frame {
public:
    explicit Window(run::Store& store) : m_store(store) {}
    run::Store& store() override { return m_store; }
    render::Stage* stageFor(const std::shared_ptr<const core::World>&) override { return nullptr; }
    ui::PaletteName colours() const override { return ui::PaletteName::Dusk; }
    void replacePage(ui::Page* page) override { openPage(page); }
    void openPage(ui::Page*) override {}
    std::optional<std::string> openRun(const RunRequest&) override { return "no run here"; }
    std::optional<std::string> openDebrief(const fs::path&) override { return "no debrief here"; }

private:
    run::Store& m_store;
};

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
        Window window(*kept);
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

TEST_F(SettingsDoor, WithoutADatabaseSettingsHoldAndThePageSaysHowLong) {
    std::ofstream(m_folder / "sagara.db") << "this is no database, whatever its name says";
    const auto kept = store();
    ASSERT_EQ(kept->database(), nullptr);
    Window window(*kept);
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
