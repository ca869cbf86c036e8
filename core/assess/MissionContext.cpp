#include "core/assess/MissionContext.h"

#include <algorithm>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

std::string join(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return all;
}

}  // namespace

std::uint8_t MissionContext::readLines(config::Reader& in, const char* key) const {
    std::uint8_t mask = 0;
    for (const std::string& name : in.texts(key)) {
        const auto it = std::find(lineIds.begin(), lineIds.end(), name);
        if (it == lineIds.end()) {
            in.problem(key, "names \"" + name + "\"", "lines of the ship: " + join(lineIds));
        } else {
            mask = static_cast<std::uint8_t>(mask | (1U << (it - lineIds.begin())));
        }
    }
    return mask;
}

NorthEast MissionContext::readPlace(config::Reader& in, const char* key) const {
    const std::string member(key);
    if (in.has(member + ".lat") || in.has(member + ".lon")) return area.frame.toLocal(in.geoPoint(key));
    const std::string id = in.text(key);
    if (const Place* place = area.findPlace(id)) return place->position;
    if (!id.empty())
        in.problem(key, "is \"" + id + "\"",
                   "a place of area " + area.id + ", or a position with lat and lon");
    return {};
}

std::size_t MissionContext::readWaypoint(config::Reader& in, const char* key) const {
    const auto count = static_cast<int>(route.waypoints.size());
    if (count == 0) {
        in.problem(key, "has no route to count in", "a scenario with a route");
        (void)in.has(key);
        return 0;
    }
    return static_cast<std::size_t>(in.integer(key, 1, count) - 1);
}

std::vector<SpeedZone> MissionContext::readSpeedZones(config::Reader& in, const char* key) const {
    std::vector<SpeedZone> zones;
    for (const config::Node& node : in.list(key)) {
        config::Reader item(node);
        SpeedZone zone;
        zone.speed_mps = kKnot_mps * item.number("speed_kn", {0.5, 60.0, "kn"});
        zone.circle = item.has("near");
        if (zone.circle) {
            zone.centre = readPlace(item, "near");
            zone.radius_m = kNauticalMile_m * item.number("within_M", {0.01, 20.0, "M"});
        } else {
            zone.toWaypoint = readWaypoint(item, "toWaypoint");
        }
        item.rejectUnknownKeys();
        zones.push_back(zone);
    }
    return zones;
}

}  // namespace sagara::core
