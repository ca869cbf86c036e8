#include "app/import/AreaWriter.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/world/Area.h"

namespace sagara::importer {
namespace {

using Json = nlohmann::ordered_json;

/// A centimetre and less: what a made position is worth.
double rounded(double degrees) { return std::round(degrees * 1e7) / 1e7; }

Json at(core::GeoPoint p) { return {{"lat", p.lat_deg}, {"lon", p.lon_deg}}; }

Json at(const core::LocalFrame& frame, core::NorthEast local) {
    const core::GeoPoint p = frame.toGeo(local);
    return at({rounded(p.lat_deg), rounded(p.lon_deg)});
}

Json points(const std::vector<core::GeoPoint>& list) {
    Json all = Json::array();
    for (const core::GeoPoint p : list) all.push_back({p.lat_deg, p.lon_deg});
    return all;
}

Json rings(const std::vector<GeoRing>& list) {
    Json all = Json::array();
    for (const GeoRing& ring : list) all.push_back({{"points", points(ring)}});
    return all;
}

/// As the area document calls it; shoreKindName is for people and differs for Other.
const char* kindName(core::ShoreKind kind) {
    return kind == core::ShoreKind::Other ? "other" : core::shoreKindName(kind);
}

Json shoreline(const std::vector<CoastLine>& lines) {
    Json all = Json::array();
    for (const CoastLine& line : lines) {
        Json item{{"kind", kindName(line.kind)}};
        if (!line.name.empty()) item["name"] = line.name;
        item["points"] = points(line.points);
        all.push_back(std::move(item));
    }
    return all;
}

Json tide(const TideRules& rules, const TideConstants& constants) {
    Json list = Json::array();
    for (const auto& c : constants.constituents) {
        list.push_back({{"name", c.name}, {"amplitude_m", c.amplitude_m}, {"phaseLag_deg", c.phaseLag_deg}});
    }
    return {
        {"source", rules.source}, {"meanAboveDatum_m", constants.meanAboveDatum_m}, {"constituents", list}};
}

Json grids(const std::vector<GridContent>& list) {
    Json all = Json::array();
    for (const GridContent& grid : list) {
        Json values = Json::array();
        for (const double v : grid.values) values.push_back(std::lround(v / grid.unit));
        const Raster& r = grid.raster;
        all.push_back({{"southWest", {{"north_m", r.southWest.north_m}, {"east_m", r.southWest.east_m}}},
                       {"spacing_m", r.spacing_m},
                       {"rows", r.rows},
                       {"columns", r.columns},
                       {"unit", grid.unit},
                       {"values", std::move(values)}});
    }
    return all;
}

Json berth(const BerthRules& rules, const BerthPlan& plan, const core::LocalFrame& frame) {
    Json bollards = Json::array(), fenders = Json::array();
    for (const auto& b : plan.bollards) bollards.push_back({{"id", b.id}, {"at", at(frame, b.position)}});
    for (const core::NorthEast position : plan.fenders) {
        fenders.push_back({{"at", at(frame, position)},
                           {"thickness_m", rules.fenderThickness_m},
                           {"width_m", rules.fenderWidth_m},
                           {"stiffness_kNpm", rules.fenderStiffness_kNpm}});
    }
    return {{"id", rules.id},           {"name", rules.name},   {"face", points({rules.a, rules.b})},
            {"depth_m", rules.depth_m}, {"bollards", bollards}, {"fenders", fenders}};
}

Json berths(const ImportDescription& d, const std::vector<BerthPlan>& plans) {
    const core::LocalFrame frame(d.datum);
    Json all = Json::array();
    for (std::size_t i = 0; i < plans.size(); ++i) all.push_back(berth(d.berths[i], plans[i], frame));
    return all;
}

Json places(const std::vector<SourcePlace>& list) {
    Json all = Json::array();
    for (const SourcePlace& place : list) {
        Json item{{"id", place.id}, {"name", place.name}, {"kind", place.kind}, {"at", at(place.at)}};
        if (!place.confidence.empty()) item["confidence"] = place.confidence;
        all.push_back(std::move(item));
    }
    return all;
}

std::string lines(const Json& list) {
    std::string text = "[";
    for (const Json& item : list) text += (text.size() > 1 ? ",\n" : "\n") + item.dump();
    return text + "\n]";
}

}  // namespace

std::string writeArea(const ImportDescription& description, const AreaContent& content) {
    Json area{{"document", "area"}, {"version", core::kAreaDocumentVersion}};
    area.update(Json::parse(description.areaJson));
    area["tide"] = tide(description.tide, content.tide);
    area["land"] = rings(content.coast.land);
    area["context"] = rings(content.coast.context);
    area["shoreline"] = shoreline(content.coast.lines);
    area["berths"] = berths(description, content.berths);
    area["places"] = places(content.places);
    area["depths"] = grids(content.depths);
    area["shelter"] = grids(content.shelter);
    area["elevation"] = grids(content.elevation);
    std::string text;
    for (const auto& [key, value] : area.items()) {
        text += (text.empty() ? "{\n" : ",\n") + Json(key).dump() + ": " +
                (value.is_array() ? lines(value) : value.dump());
    }
    return text + "\n}\n";
}

}  // namespace sagara::importer
