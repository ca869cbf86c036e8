#include "ui/vessels/StudioWorld.h"

#include "core/base/Units.h"
#include "core/exercise/Snapshot.h"

namespace sagara::ui {

std::shared_ptr<const core::World> studioWorld(const core::Vessel& vessel, bool night) {
    core::Area area;
    area.id = std::string("studio");
    area.name = std::string("Open water");
    area.frame = core::LocalFrame(core::GeoPoint{5.9, 80.2});
    area.ialaRegion = std::string(1, 'A');
    area.waveDepth_m = 200.0;
    constexpr double kHalf_m = 5000.0;
    area.depths.emplace_back(core::NorthEast{-kHalf_m, -kHalf_m}, kHalf_m, 3, 3,
                             std::vector<float>(9, 200.0F));
    auto world = std::make_shared<core::World>(std::move(area), 1);
    world->scenarioId = world->area.id;
    world->scenarioName = vessel.name;
    world->start =
        core::parseUtc(night ? "2027-01-15T14:00:00Z" : "2027-01-15T03:30:00Z").value_or(core::Utc{});
    world->longest_s = 3600.0;
    world->weather.wind.speed_mps = 3.0;
    world->weather.wind.windFrom_rad = 0.8;
    world->weather.visibility_m = 15.0 * core::kNauticalMile_m;
    for (auto& level : world->levels) level = {1.0, 1.0, 1.0};
    world->ships.push_back(std::make_unique<core::OwnShip>("own", vessel.name, vessel));
    return world;
}

render::Moment studioMoment(const core::World& world) {
    return render::momentOf(core::view(world, core::startState(world, 3)));
}

}  // namespace sagara::ui
