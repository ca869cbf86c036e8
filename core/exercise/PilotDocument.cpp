#include "core/exercise/PilotDocument.h"

#include <algorithm>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

const config::Range kSeconds{0.0, 3600.0, "s"};

LinesStep readLines(config::Reader& in, const MissionContext& context) {
    LinesStep step;
    if (in.has("letGo")) step.letGo = context.readLines(in, "letGo");
    if (in.has("slack")) step.slack = context.readLines(in, "slack");
    if (in.has("heave")) step.heave = context.readLines(in, "heave");
    if (in.has("hold")) step.hold = context.readLines(in, "hold");
    step.wait_s = in.numberOr("wait_s", 0.0, kSeconds);
    return step;
}

std::array<double, kMostShafts> readShafts(config::Reader& in, const Vessel& vessel) {
    std::array<double, kMostShafts> shafts_rps{};
    const std::size_t count = vessel.propulsion.units.size();
    const std::vector<double> rpm = in.numbers("shafts_rpm", count, {-3000.0, 3000.0, "rpm"});
    for (std::size_t i = 0; i < count; ++i) shafts_rps[i] = kRpm_rps * rpm[i];
    return shafts_rps;
}

RunStep readRun(config::Reader& in, const Vessel& vessel) {
    RunStep step;
    step.rudder_rad = kDegree_rad * in.number("rudder_deg", {-70.0, 70.0, "deg"});
    step.shafts_rps = readShafts(in, vessel);
    if (in.has("headingChange_deg"))
        step.headingChange_rad = kDegree_rad * in.number("headingChange_deg", {1.0, 360.0, "deg"});
    if (in.has("moved_m")) step.moved_m = in.number("moved_m", {1.0, 5000.0, "m"});
    if (in.has("slowerThan_kn"))
        step.slowerThan_mps = kKnot_mps * in.number("slowerThan_kn", {0.05, 30.0, "kn"});
    step.atMost_s = in.number("atMost_s", kSeconds);
    return step;
}

TurnStep readTurn(config::Reader& in) {
    const double heading_rad = kDegree_rad * in.number("heading_deg", {0.0, 360.0, "deg"});
    return {heading_rad, kRpm_rps * in.number("shaft_rpm", {1.0, 3000.0, "rpm"})};
}

TrackStep readTrack(config::Reader& in, const MissionContext& context) {
    TrackStep step;
    step.speeds = context.readSpeedZones(in, "speeds");
    step.cruise_mps = kKnot_mps * in.number("cruise_kn", {0.5, 60.0, "kn"});
    const std::size_t to = context.readWaypoint(in, "toWaypoint");
    const double before_m = in.numberOr("before_m", 0.0, {0.0, 5000.0, "m"});
    step.untilAlong_m = context.route.waypoints.empty() ? 0.0 : context.path.alongOf(to) - before_m;
    return step;
}

AnchorStep readAnchor(config::Reader& in, const MissionContext& context, const Vessel& vessel) {
    AnchorStep step;
    step.place = context.readPlace(in, "at");
    const std::string id = in.text("anchor");
    const auto& anchors = vessel.groundTackle.anchors;
    const auto it =
        std::find_if(anchors.begin(), anchors.end(), [&](const AnchorGear& a) { return a.id == id; });
    if (it == anchors.end() && !id.empty())
        in.problem("anchor", "is \"" + id + "\"", "an anchor of vessel " + vessel.id);
    if (it != anchors.end()) step.anchor = static_cast<std::uint8_t>(it - anchors.begin());
    step.firstCable_m = kShackle_m * in.number("first_shackles", {0.5, 20.0, "shackles"});
    step.cable_m = kShackle_m * in.number("shackles", {0.5, 20.0, "shackles"});
    step.approach_mps = kKnot_mps * in.number("approach_kn", {0.5, 10.0, "kn"});
    return step;
}

}  // namespace

PilotScript readPilotScript(config::Reader& scenario, const MissionContext& context, const Vessel& vessel) {
    enum class Do { Lines, Run, Turn, Track, Anchor };
    PilotScript script;
    for (const config::Node& node : scenario.listOr("pilot")) {
        config::Reader in(node);
        const auto what = in.choiceIfKnown<Do>("do", {{"lines", Do::Lines},
                                                      {"run", Do::Run},
                                                      {"turn", Do::Turn},
                                                      {"track", Do::Track},
                                                      {"anchor", Do::Anchor}});
        if (!what) continue;
        switch (*what) {
            case Do::Lines:
                script.emplace_back(readLines(in, context));
                break;
            case Do::Run:
                script.emplace_back(readRun(in, vessel));
                break;
            case Do::Turn:
                script.emplace_back(readTurn(in));
                break;
            case Do::Track:
                script.emplace_back(readTrack(in, context));
                break;
            case Do::Anchor:
                script.emplace_back(readAnchor(in, context, vessel));
                break;
        }
        in.rejectUnknownKeys();
    }
    return script;
}

}  // namespace sagara::core
