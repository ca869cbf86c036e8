#include "ui/sound/SoundScene.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "ui/sound/FogSignal.h"
#include "ui/sound/Synthesis.h"

namespace sagara::ui {
namespace {

constexpr double kSoundSpeed_mps = 340.0;
constexpr double kHeard_m = 4000.0;  ///< two miles: the most annex III asks of a whistle
constexpr double kLink_m = 0.15;     ///< pitch of a link of 36 mm cable, links lie crosswise

/// Shafts that turn faster than this at full ahead are driven by a geared four-stroke, others directly by a
/// slow two-stroke.
constexpr double kDirect_rps = 3.5;

SoundScene::Engine engineOf(double shaft_rps, double full_rps) {
    SoundScene::Engine engine;
    engine.shaft_rpm = 60.0 * shaft_rps;
    const double share = full_rps > 0.0 ? std::min(1.0, std::abs(shaft_rps) / full_rps) : 0.0;
    engine.load = share * share;
    engine.turning = share > 0.01;
    if (full_rps < kDirect_rps) {
        engine.firing_Hz = engine.turning ? 7.0 * std::abs(shaft_rps) : 0.0;  // seven cylinders
    } else {
        // Six cylinders of a four-stroke that idles at a third of its full speed of 1800 rpm.
        constexpr double kFull_Hz = 1800.0 / 60.0 * 3.0;
        engine.firing_Hz = kFull_Hz * std::max(1.0 / 3.0, share);
    }
    return engine;
}

SoundPlace placeOf(const core::HeadingFrame& frame, core::NorthEast p, double up_m) {
    const core::BodyPoint b = frame.pointInBody(p);
    return {b.x_m, b.y_m, up_m};
}

/// Ships do not sound all at once: everyone has a clock of his own.
double clockOf(std::size_t index) { return 37.0 * static_cast<double>(index + 1); }

void addOthers(const core::World& world, const core::Snapshot& now, const core::HeadingFrame& frame,
               SoundScene& scene) {
    if (now.weather.visibility_m >= kRestrictedVisibility_m) return;
    std::vector<std::pair<double, SoundScene::Other>> heard;
    for (const core::TargetView& target : now.targets) {
        const core::TargetLayout& layout = world.targets[target.index];
        if (layout.length_m < 12.0) continue;  // rule 35(j): a small vessel need not
        const SoundPlace at = placeOf(frame, target.position, 0.1 * layout.length_m);
        const double away_m = std::hypot(at.forward_m, at.starboard_m);
        if (away_m > kHeard_m) continue;
        const double left_s = now.time().seconds() - away_m / kSoundSpeed_mps + clockOf(target.index);
        const FogSignal signal = fogSignal(target.activity, target.speed_mps > 0.3, layout.length_m, left_s);
        heard.push_back(
            {away_m,
             {target.index, at, whistlePitch_Hz(layout.length_m), signal.horn, signal.bell, signal.gong}});
    }
    std::stable_sort(heard.begin(), heard.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    if (heard.size() > kMostHeard) heard.resize(kMostHeard);
    for (auto& [away_m, other] : heard) scene.others.push_back(other);
}

}  // namespace

SoundScene soundSceneOf(const core::World& world, const core::Snapshot& now, const BridgeSounds& bridge,
                        std::size_t index) {
    SoundScene scene;
    if (index >= now.ships.size() || index >= world.ships.size()) return scene;
    const core::OwnShipView& ship = now.ships[index];
    const core::Vessel& vessel = world.ships[index]->vessel;
    const double half_m = 0.5 * vessel.hull.lengthOverall_m;

    const double full_rps = vessel.propulsion.telegraph_rps.back();
    double strongest = 0.0;
    for (const double shaft_rps : ship.shafts_rps) {
        scene.engines.push_back(engineOf(shaft_rps, full_rps));
        strongest = std::max(strongest, full_rps > 0.0 ? std::abs(shaft_rps) / full_rps : 0.0);
        scene.blades_Hz = std::max(scene.blades_Hz, 4.0 * std::abs(shaft_rps));
    }
    scene.enginesAt = {-0.25 * half_m, 0.0, 0.0};
    scene.wash = std::min(1.0, strongest * strongest);
    scene.washAt = {-half_m, 0.0, 0.0};

    scene.speed_mps = std::hypot(ship.motion.surge_mps, ship.motion.sway_mps);
    // A bow wave is heard from about two knots; it is full where a ship of her length makes it so.
    const double froude = scene.speed_mps / std::sqrt(core::kGravity_mps2 * 2.0 * half_m);
    scene.bowWave = std::clamp((scene.speed_mps - 0.8) / 8.0 + froude - 0.1, 0.0, 1.0);
    if (scene.speed_mps < 0.8) scene.bowWave = 0.0;
    scene.bowAt = {half_m, 0.0, 0.0};

    const core::NorthEast felt =
        -now.wind.speed_mps * core::unitVector(now.wind.windFrom_rad) - ship.overGround_mps;
    scene.windSpeed_mps = core::length(felt);
    scene.windFrom_rad = std::atan2(-felt.east_m, -felt.north_m) - ship.motion.heading_rad;
    scene.wind = std::clamp((scene.windSpeed_mps - 1.0) / 24.0, 0.0, 1.0);
    scene.rain = std::clamp(now.weather.rain, 0.0, 1.0);

    scene.horn = bridge.horn;
    scene.bell = bridge.bell;
    scene.alarm = bridge.alarm;
    scene.hornPitch_Hz = whistlePitch_Hz(vessel.hull.lengthOverall_m);
    const double eye_m = vessel.bridgeEyeHeight_m;
    scene.hornAt = {vessel.bridgeEye.x_m, vessel.bridgeEye.y_m, eye_m + 4.0};
    scene.forecastle = {0.95 * half_m, 0.0, 0.5 * eye_m};
    for (std::size_t i = 0; i < ship.anchors.size() && i < vessel.groundTackle.anchors.size(); ++i) {
        const double heave_mps = vessel.groundTackle.anchors[i].heaveSpeed_mps;
        double links_Hz = 0.0;
        if (ship.anchors[i].status == core::AnchorStatus::Running) links_Hz = 5.0 / kLink_m;
        if (ship.anchors[i].status == core::AnchorStatus::Veering ||
            ship.anchors[i].status == core::AnchorStatus::Heaving)
            links_Hz = heave_mps / kLink_m;
        scene.cableLinks_Hz = std::max(scene.cableLinks_Hz, links_Hz);
    }

    const core::HeadingFrame frame(ship.motion.position(), ship.motion.heading_rad);
    addOthers(world, now, frame, scene);
    scene.listener = {{vessel.bridgeEye.x_m, vessel.bridgeEye.y_m, eye_m}, bridge.look_rad, bridge.outside};
    return scene;
}

}  // namespace sagara::ui
