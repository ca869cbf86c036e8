#include "core/exercise/TrafficDocument.h"

#include <set>

#include "core/assess/MissionContext.h"
#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "core/vessel/Hull.h"

namespace sagara::core {
namespace {

/// What she does, when it is said, must go with how she moves.
Activity readActivity(config::Reader& in, const TargetLayout& t) {
    if (!in.has("activity")) return usualActivity(t.type, t.behaviour);
    const auto named = [](Activity a) { return config::Reader::Choice<Activity>{activityName(a), a}; };
    using enum Activity;
    const auto activity = in.choiceIfKnown<Activity>(
        "activity", {named(UnderWay), named(Anchored), named(Fishing), named(Trawling), named(Towing),
                     named(NotUnderCommand), named(Restricted), named(Moored), named(Sailing)});
    if (activity && !isUnderWay(*activity) && t.behaviour != TargetBehaviour::Lying)
        in.problem("activity", std::string("is \"") + activityName(*activity) + "\"",
                   "that of a vessel under way, for she is not lying");
    return activity.value_or(Activity::UnderWay);
}

TargetLayout readTarget(const config::Node& node, const LocalFrame& frame) {
    config::Reader in(node);
    TargetLayout t;
    t.id = in.id("id");
    t.name = in.text("name");
    t.type = readTargetType(in);
    t.behaviour = in.choice<TargetBehaviour>("behaviour", {{"route", TargetBehaviour::Route},
                                                           {"circuit", TargetBehaviour::Circuit},
                                                           {"lying", TargetBehaviour::Lying},
                                                           {"hostile", TargetBehaviour::Hostile},
                                                           {"course", TargetBehaviour::Course}});
    t.activity = readActivity(in, t);
    t.length_m = in.number("length_m", {3.0, 400.0, "m"});
    t.beam_m = in.number("beam_m", {1.0, 70.0, "m"});
    t.draught_m = in.number("draught_m", {0.2, 25.0, "m"});
    t.fromLevel = in.integerOr("fromLevel", 1, 1, kLevels);
    t.onEvent = in.flagOr("onEvent", false);
    if (in.has("heading_deg") || t.behaviour == TargetBehaviour::Course)
        t.heading_rad = kDegree_rad * in.number("heading_deg", {0.0, 360.0, "deg"});
    if (in.has("picture")) t.picture = in.id("picture");
    for (const config::Node& item : in.list("route")) {
        config::Reader waypoint(item);
        const NorthEast at = frame.toLocal(waypoint.geoPoint("at"));
        t.route.push_back({at, kKnot_mps * waypoint.numberOr("speed_kn", 0.0, {0.0, 60.0, "kn"})});
        waypoint.rejectUnknownKeys();
    }
    const bool moves = t.behaviour == TargetBehaviour::Route || t.behaviour == TargetBehaviour::Circuit;
    if (in.has("route") && t.route.size() < (moves ? 2u : 1u)) {
        in.problem("route", "has " + std::to_string(t.route.size()) + " points",
                   moves ? "at least two" : "at least one");
    }
    in.rejectUnknownKeys();
    t.outline = outlineOf(t.length_m, t.beam_m);
    return t;
}

}  // namespace

TargetType readTargetType(config::Reader& in) {
    return in.choice<TargetType>("type", {{"fishing", TargetType::Fishing},
                                          {"coaster", TargetType::Coaster},
                                          {"tanker", TargetType::Tanker},
                                          {"container", TargetType::Container},
                                          {"ferry", TargetType::Ferry},
                                          {"yacht", TargetType::Yacht},
                                          {"tug", TargetType::Tug},
                                          {"fastCraft", TargetType::FastCraft}});
}

std::vector<TargetLayout> readTraffic(config::Reader& scenario, const LocalFrame& frame) {
    std::vector<TargetLayout> targets;
    std::set<std::string> seen;
    for (const config::Node& node : scenario.listOr("traffic")) {
        targets.push_back(readTarget(node, frame));
        const std::string& id = targets.back().id;
        if (!id.empty() && !seen.insert(id).second)
            node.problem("has the id \"" + id + "\" again", "each id once");
    }
    return targets;
}

}  // namespace sagara::core
