#pragma once

#include <QStackedWidget>
#include <functional>
#include <future>
#include <vector>

#include "app/station/Frame.h"
#include "ui/input/BridgeInput.h"
#include "ui/settings/SettingsStore.h"
#include "ui/sound/SoundBoard.h"
#include "ui/widgets/PreparedExercise.h"

class QLabel;
class QToolButton;

namespace sagara::station {

/// How much the station's own views are to draw: the wall has the machine's other cores where there is no
/// graphics card.
render::Preset presetOfThisMachine();

/// The station's window: a bar and a stack of pages, of which the topmost is shown. Starts with the page of
/// the doors.
class Station final : public QWidget, public Frame {
    Q_OBJECT

public:
    Station(run::Store& store, render::StageOptions stage);
    ~Station() override;

    // Frame
    run::Store& store() override { return m_store; }
    render::Stage* stageFor(const std::shared_ptr<const core::World>& world) override;
    ui::PaletteName colours() const override { return m_colours; }
    void openPage(ui::Page* page) override;
    void replacePage(ui::Page* page) override;
    std::optional<std::string> openRun(const RunRequest& request) override;
    std::optional<std::string> openDebrief(const std::filesystem::path& recording) override;
    /// The trainer's desk of an exercise that is built already; `request.scenario` is its own.
    std::optional<std::string> openDesk(const RunRequest& request, const ui::PreparedExercise& exercise);

    /// Day, dusk or night for every window of the program; remembered.
    void setColours(ui::PaletteName name);
    ui::SettingsStore& settings() { return *m_settings; }
    ui::BridgeInput& input() { return m_input; }
    ui::SoundBoard& sound() { return m_sound; }

    ui::Page* page() const;
    std::size_t depth() const { return m_pages.size(); }
    /// Back to the page before, if the present one may be left. False when it stays.
    bool leavePage();
    /// Back to the doors.
    bool leaveAll();
    /// Pages that fill the screen have no bar.
    void setBarShown(bool shown);
    void help();
    void openSettings();

protected:
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* makeBar();
    void showTop();
    void dropTop();
    void refreshBar();

    run::Store& m_store;
    render::StageOptions m_stageOptions;
    std::unique_ptr<ui::SettingsStore> m_settings;
    ui::BridgeInput m_input;
    ui::SoundBoard m_sound;
    ui::PaletteName m_colours = ui::PaletteName::Day;
    std::future<std::unique_ptr<render::Stage>> m_stageComing;  ///< opened aside from the start on
    std::unique_ptr<render::Stage> m_stage;
    std::weak_ptr<const core::World> m_staged;
    QWidget* m_bar;
    QLabel* m_title;
    QToolButton* m_back;
    std::vector<std::pair<QToolButton*, QString>> m_icons;  ///< to be drawn anew in other colours
    QStackedWidget* m_stack;
    std::vector<ui::Page*> m_pages;
};

}  // namespace sagara::station
