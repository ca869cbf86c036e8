#pragma once

#include "app/station/Frame.h"

namespace sagara::station {

/// For a door that opens no other page: no window, no scene.
class NoWindow final : public Frame {
public:
    explicit NoWindow(run::Store& store, ui::PaletteName colours = ui::PaletteName::Day)
        : m_store(store), m_colours(colours) {}
    run::Store& store() override { return m_store; }
    render::Stage* stageFor(const std::shared_ptr<const core::World>&) override { return nullptr; }
    ui::PaletteName colours() const override { return m_colours; }
    void openPage(ui::Page* page) override { delete page; }
    void replacePage(ui::Page* page) override { delete page; }
    std::optional<std::string> openRun(const RunRequest&) override { return "no run here"; }
    std::optional<std::string> openDebrief(const std::filesystem::path&) override {
        return "no debrief here";
    }

private:
    run::Store& m_store;
    ui::PaletteName m_colours;
};

}  // namespace sagara::station
