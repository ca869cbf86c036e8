#pragma once

#include "app/station/DemoRun.h"
#include "app/station/StationWall.h"

namespace sagara::station {

/// The wall of the exhibition. A channel that is lost is the wall's own business; another world gets another
/// wall, and the one before is let go of without waiting.
class DemoStationWall final : public ui::DemoWall {
public:
    /// `run` outlives it.
    DemoStationWall(const DemoRun& run, std::string layout, ui::WallPlacement placement)
        : m_run(run), m_layout(std::move(layout)), m_placement(placement) {}

    void show() override;
    ui::WallControl::Status status() const { return m_wall ? m_wall->status() : ui::WallControl::Status{}; }

private:
    const DemoRun& m_run;
    std::string m_layout;
    ui::WallPlacement m_placement;
    std::shared_ptr<const core::World> m_world;
    std::unique_ptr<StationWall> m_wall;
    std::unique_ptr<StationWall> m_before;  ///< stopping
};

}  // namespace sagara::station
