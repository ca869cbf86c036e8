#include "tests/ui/widgets/LessonScene.h"

#include "core/base/Units.h"
#include "core/exercise/Prediction.h"
#include "core/exercise/Session.h"
#include "core/exercise/Snapshot.h"
#include "tests/support/Assets.h"
#include "tests/support/exercise/Lesson.h"
#include "ui/widgets/SnapshotScene.h"

namespace sagara::ui::test {
namespace {

constexpr double kLocalStart_s = 9.0 * 3600.0;

core::NorthEast place(const char* id) { return lesson()->area.findPlace(id)->position; }

/// As the tasks of the lesson have them.
std::vector<ChartZone> zonesOf(const core::Snapshot& now) {
    const auto kind = [&](std::size_t task) {
        return task < now.tasks.size() && now.tasks[task].done ? ChartZone::Kind::Done
                                                               : ChartZone::Kind::Task;
    };
    return {{1,
             QStringLiteral("Pass the entrance"),
             kind(2),
             {},
             0.0,
             {place("s_breakwater_head"), place("w_breakwater_head")}},
            {2,
             QStringLiteral("Transit to the anchorage"),
             kind(3),
             place("anch_ne_monsoon"),
             0.2 * core::kNauticalMile_m,
             {}},
            {3, QStringLiteral("Anchor and bring up"), kind(4), place("anch_ne_monsoon"), 75.0, {}},
            {4,
             QStringLiteral("Keep out: rocks"),
             ChartZone::Kind::Limit,
             {},
             0.0,
             {{1080, -130}, {1120, -60}, {1060, 40}, {1010, -40}}}};
}

ChartScene sceneOf(const core::World& world, const core::State& state, const ChartTrack& track) {
    const core::Snapshot now = core::view(world, state);
    ChartScene scene;
    scene.ownShips = ownShipsOf(world, now);
    scene.targets = targetsOf(world, now);
    scene.tracks = {track};
    scene.predictions = {predictionOf(world, 0, core::predict(world, state, 0, 360.0, 10.0))};
    scene.route = world.route;
    scene.path = world.path;
    scene.zones = zonesOf(now);
    scene.anchors = anchorsOf(world, now);
    scene.clearance_m = 463.0;
    scene.clockAtZero_s = kLocalStart_s;
    return scene;
}

}  // namespace

std::shared_ptr<const PreparedChart> galle() {
    static const auto prepared = [] {
        auto area = core::loadArea("area.json", sagara::test::readAsset("areas/galle/area.json"));
        return prepareChart(std::make_shared<const core::Area>(std::move(area).value()), 5.0);
    }();
    return prepared;
}

std::shared_ptr<const core::World> lesson() {
    static const auto world = sagara::test::lessonWorld();
    return world;
}

ChartScene lessonAtBerth() { return sceneOf(*lesson(), core::startState(*lesson(), 3), {}); }

std::vector<ChartScene> sailedLesson(const std::vector<double>& minutes) {
    const auto world = lesson();
    core::Session session(world, core::startState(*world, 3), {{0, 0, core::PilotOrder{true}}}, nullptr);
    std::vector<ChartScene> scenes;
    ChartTrack track;
    while (scenes.size() < minutes.size() && !session.over()) {
        const core::State& state = session.state();
        if (state.tick % core::kTicksPerSecond == 0)
            track.points.push_back({state.time().seconds(), state.ships[0].motion.position()});
        if (state.time().seconds() >= 60.0 * minutes[scenes.size()])
            scenes.push_back(sceneOf(*world, state, track));
        (void)session.step();
    }
    if (scenes.size() < minutes.size()) scenes.push_back(sceneOf(*world, session.state(), track));
    return scenes;
}

}  // namespace sagara::ui::test
