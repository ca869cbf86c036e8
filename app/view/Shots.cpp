#include "app/view/Shots.h"

#include <cstdio>
#include <numbers>

#include "app/view/AreaViews.h"
#include "core/exercise/Session.h"

namespace sagara::view {
namespace {

using render::Camera;
using render::Lens;

using Shot = AreaView;

std::vector<Shot> shotsOf(const core::World& world, const render::Moment& m, const ShotOptions& o) {
    const double fov = std::numbers::pi / 3.0;
    const Lens lens = Lens::symmetric(fov, o.width, o.height);
    std::vector<Shot> shots;
    if (!m.ships.empty()) {
        const double length_m = world.ships[0]->vessel.hull.lengthOverall_m;
        const core::NorthEast ship = m.ships[0].position;
        const Camera bridge = bridgeCamera(world, m, 0, 0.0, lens);
        shots.push_back({"bridge", bridge});
        shots.push_back({"bridge-port", bridgeCamera(world, m, 0, -fov, lens)});
        shots.push_back({"bridge-starboard", bridgeCamera(world, m, 0, fov, lens)});
        shots.push_back({"bridge-astern", bridgeCamera(world, m, 0, std::numbers::pi, lens)});
        shots.push_back({"binoculars", bridgeCamera(world, m, 0, 0.0, lens.magnified(7.0))});
        shots.push_back({"wing", wingCamera(world, m, 0, render::WingSide::Starboard, 0.5, lens)});
        shots.push_back({"chase", chaseCamera(m.ships[0], length_m, 0.5, lens)});
        shots.push_back(
            {"beside", render::shoreCamera(ship + core::NorthEast{-60.0, 75.0}, 12.0, ship, 4.0, lens)});
        const core::HeadingFrame deck(ship, m.ships[0].heading_rad);
        shots.push_back({"bow", render::shoreCamera(deck.point({0.5 * length_m + 24.0, -16.0}), 7.0,
                                                    deck.point({0.3 * length_m, 0.0}), 3.0, lens)});
        shots.push_back({"quarter", render::shoreCamera(deck.point({-0.5 * length_m - 24.0, -16.0}), 7.0,
                                                        deck.point({-0.3 * length_m, 0.0}), 3.0, lens)});
    }
    for (const render::TargetPose& target : m.targets) {
        const core::TargetLayout& layout = core::targetLayout(world, m.added, target.index);
        const core::NorthEast from =
            target.position + (-1.6 * layout.length_m - 6.0) * core::unitVector(target.heading_rad + 2.5);
        shots.push_back({"target-" + layout.id, render::shoreCamera(from, 0.25 * layout.length_m + 3.0,
                                                                    target.position, 2.0, lens)});
    }
    for (AreaView& view : viewsOf(world.area, lens)) shots.push_back(std::move(view));
    return shots;
}

}  // namespace

int takeShots(const ScenarioRequest& request, const render::StageOptions& stageOptions,
              const ShotOptions& options) {
    const auto tell = [](const std::string& text) { std::fprintf(stderr, "%s\n", text.c_str()); };
    const auto world = worldOf(request);
    if (!world) return tell(world.error()), 2;
    auto stage = render::Stage::open(stageOptions);
    if (!stage) return tell(stage.error()), 3;
    if (auto trouble = (*stage)->show(*world)) return tell(*trouble), 3;
    for (const std::string& remark : (*stage)->remarks()) tell(remark);
    const auto view = (*stage)->addViewport(options.width, options.height);
    const core::SimTime until{static_cast<std::int64_t>(1e6 * options.at_s)};
    const render::Moment moment =
        render::momentOf(core::view(**world, core::sailedByPilot(*world, request.level, until)));
    std::filesystem::create_directories(options.folder);
    for (const Shot& shot : shotsOf(**world, moment, options)) {
        if (!options.only.empty() && shot.name.find(options.only) != 0) continue;
        view->setCamera(shot.camera);
        if (auto trouble = (*stage)->draw(moment)) return tell(*trouble), 3;
        const auto path = options.folder / (shot.name + ".png");
        if (auto trouble = writePng(*view->latest(), path)) return tell(*trouble), 3;
        std::printf("%s: %zu triangles, %zu draw calls\n", path.c_str(), view->figures().triangles,
                    view->figures().drawCalls);
    }
    return 0;
}

}  // namespace sagara::view
