#include "app/import/ImportDescription.h"

#include <nlohmann/json.hpp>

#include "core/base/Config.h"

namespace sagara::importer {
namespace {

using core::ShoreKind;
using core::config::Node;
using core::config::Reader;

GeoBox readBox(const Node& node) {
    Reader in(node);
    const GeoBox box{
        in.number("south_deg", {-89.0, 89.0, "deg"}), in.number("west_deg", {-180.0, 180.0, "deg"}),
        in.number("north_deg", {-89.0, 89.0, "deg"}), in.number("east_deg", {-180.0, 180.0, "deg"})};
    in.rejectUnknownKeys();
    if (box.south_deg >= box.north_deg)
        in.problem("north_deg", "is not north of south_deg", "a box with an inside");
    if (box.west_deg >= box.east_deg)
        in.problem("east_deg", "is not east of west_deg", "a box with an inside");
    return box;
}

GridRules readGrid(Reader& in) {
    return {readBox(in.child("box")), in.number("spacing_m", {0.5, 5000.0, "m"})};
}

std::vector<GridRules> readGrids(Reader& in) {
    std::vector<GridRules> grids;
    for (const Node& node : in.list("grids")) {
        Reader grid(node);
        grids.push_back(readGrid(grid));
        grid.rejectUnknownKeys();
    }
    if (grids.empty() && in.has("grids")) in.problem("grids", "is empty", "at least one grid");
    return grids;
}

ShoreKind readKind(Reader& in) {
    return in.choice<ShoreKind>("kind", {{"quay", ShoreKind::Quay},
                                         {"jetty", ShoreKind::Jetty},
                                         {"breakwater", ShoreKind::Breakwater},
                                         {"rock", ShoreKind::Rock},
                                         {"beach", ShoreKind::Beach},
                                         {"other", ShoreKind::Other}});
}

ShorelineRules readShoreline(const Node& node) {
    Reader in(node);
    ShorelineRules r;
    r.file = in.text("file");
    for (const Node& item : in.list("categories")) {
        Reader category(item);
        r.categories.push_back({category.text("category"), readKind(category)});
        category.rejectUnknownKeys();
    }
    for (const Node& item : in.listOr("corrections")) {
        Reader correction(item);
        r.corrections.push_back(
            {correction.geoPoint("near"), readKind(correction), correction.textOr("name", "")});
        correction.textOr("why", "");
        correction.rejectUnknownKeys();
    }
    in.rejectUnknownKeys();
    return r;
}

TideRules readTide(const Node& node) {
    Reader in(node);
    TideRules r{in.text("file"), in.text("source"), in.number("leastAmplitude_m", {0.0, 1.0, "m"})};
    in.rejectUnknownKeys();
    return r;
}

ElevationRules readElevation(const Node& node) {
    Reader in(node);
    ElevationRules r;
    r.file = in.text("file");
    r.grid = readGrid(in);
    r.unit_m = in.number("unit_m", {0.01, 100.0, "m"});
    r.landAtLeast_m = in.number("landAtLeast_m", {-10.0, 100.0, "m"});
    in.rejectUnknownKeys();
    return r;
}

BedRules readBed(const Node& node) {
    Reader in(node);
    BedRules r;
    r.name = in.text("name");
    r.isLine = in.has("line");
    r.points = in.geoPoints(r.isLine ? "line" : "polygon", r.isLine ? 2 : 3);
    if (r.isLine) r.halfWidth_m = 0.5 * in.number("width_m", {1.0, 5000.0, "m"});
    if (in.has("atLeast_m")) r.atLeast_m = in.number("atLeast_m", {-5.0, 100.0, "m"});
    if (in.has("atMost_m")) r.atMost_m = in.number("atMost_m", {-5.0, 100.0, "m"});
    if (!r.atLeast_m && !r.atMost_m) in.problem("atLeast_m", "is missing", "atLeast_m or atMost_m or both");
    in.textOr("source", "");
    in.rejectUnknownKeys();
    return r;
}

Sounding readSounding(const Node& node) {
    Reader in(node);
    Sounding s{in.geoPoint("at"), in.number("depth_m", {0.1, 1000.0, "m"}), in.text("source")};
    in.rejectUnknownKeys();
    return s;
}

DepthRules readDepth(const Node& node) {
    Reader in(node);
    DepthRules r;
    r.grids = readGrids(in);
    r.unit_m = in.number("unit_m", {0.01, 10.0, "m"});
    r.profileCoefficient = in.number("profileCoefficient", {0.001, 100.0, ""});
    r.profileExponent = in.number("profileExponent", {0.1, 2.0, ""});
    r.landAtMost_m = in.number("landAtMost_m", {0.0, 100.0, "m"});
    r.worksReach_m = in.number("worksReach_m", {0.0, 1000.0, "m"});
    r.sideSlope = in.number("sideSlope", {0.01, 10.0, ""});
    r.soundingTolerance = in.number("soundingTolerance", {0.0, 10.0, ""});
    r.soundingReach_m = in.number("soundingReach_m", {1.0, 10000.0, "m"});
    for (const Node& item : in.listOr("soundings")) r.soundings.push_back(readSounding(item));
    for (const Node& item : in.listOr("beds")) r.beds.push_back(readBed(item));
    in.rejectUnknownKeys();
    return r;
}

ShelterRules readShelter(const Node& node) {
    Reader in(node);
    ShelterRules r;
    r.grids = readGrids(in);
    r.unit = in.number("unit", {0.001, 0.5, ""});
    r.waveLength_m = in.number("waveLength_m", {1.0, 1000.0, "m"});
    r.step_deg = in.number("step_deg", {0.5, 30.0, "deg"});
    for (const Node& item : in.list("sectors")) {
        Reader sector(item);
        const ShelterRules::Sector s{sector.number("from_deg", {0.0, 360.0, "deg"}),
                                     sector.number("to_deg", {0.0, 720.0, "deg"}),
                                     sector.number("share", {0.001, 1.0, ""})};
        if (s.to_deg < s.from_deg)
            sector.problem("to_deg", "is less than from_deg", "a sector that runs clockwise");
        sector.rejectUnknownKeys();
        r.sectors.push_back(s);
    }
    if (r.sectors.empty() && in.has("sectors")) in.problem("sectors", "is empty", "at least one sector");
    in.rejectUnknownKeys();
    return r;
}

void readBollards(const Node& node, BerthRules& r) {
    Reader in(node);
    r.bollardPrefix = in.text("prefix");
    r.numberedFromB = in.choice<bool>("numberedFrom", {{"a", false}, {"b", true}});
    r.bollardSpacing_m = in.number("spacing_m", {1.0, 200.0, "m"});
    r.bollardSetback_m = in.number("setback_m", {0.0, 20.0, "m"});
    in.rejectUnknownKeys();
}

void readFenders(const Node& node, BerthRules& r) {
    Reader in(node);
    r.fenderSpacing_m = in.number("spacing_m", {1.0, 200.0, "m"});
    r.fenderThickness_m = in.number("thickness_m", {0.05, 5.0, "m"});
    r.fenderWidth_m = in.number("width_m", {0.1, 20.0, "m"});
    r.fenderStiffness_kNpm = in.number("stiffness_kNpm", {1.0, 1e5, "kN/m"});
    in.rejectUnknownKeys();
}

BerthRules readBerth(const Node& node) {
    Reader in(node);
    BerthRules r;
    r.id = in.text("id");
    r.name = in.text("name");
    r.depth_m = in.number("depth_m", {0.5, 40.0, "m"});
    r.a = in.geoPoint("a");
    r.b = in.geoPoint("b");
    readBollards(in.child("bollards"), r);
    readFenders(in.child("fenders"), r);
    in.rejectUnknownKeys();
    return r;
}

/// Finest first, each inside the next, all inside the detailed box.
void checkNesting(Reader& in, const std::string& key, const std::vector<GridRules>& grids,
                  const GeoBox& detail) {
    for (std::size_t i = 0; i < grids.size(); ++i) {
        const std::string path = key + ".grids[" + std::to_string(i) + "]";
        const bool last = i + 1 == grids.size();
        if (!(last ? detail : grids[i + 1].box).covers(grids[i].box)) {
            in.problem(path + ".box", "reaches beyond " + std::string(last ? "box" : "the next grid"),
                       "each grid inside the next and the last inside box");
        }
        if (!last && grids[i].spacing_m >= grids[i + 1].spacing_m) {
            in.problem(path + ".spacing_m", "is not below that of the next grid", "the finest grid first");
        }
    }
}

core::GeoPoint readDatum(const Node& areaNode) {
    Reader area(areaNode);
    for (const char* made : {"document", "version", "tide", "land", "context", "shoreline", "berths",
                             "places", "depths", "shelter", "elevation"}) {
        if (area.has(made))
            area.problem(made, "is made by the importer", "members that are taken over as they stand");
    }
    return area.geoPoint("datum");
}

ImportDescription readAll(Reader& in) {
    in.text("document");
    in.integer("version", 1, kDescriptionVersion);
    ImportDescription d;
    d.datum = readDatum(in.child("area"));
    d.box = readBox(in.child("box"));
    Reader land(in.child("land"));
    d.landFile = land.text("file");
    d.contextFile = land.text("context");
    land.rejectUnknownKeys();
    d.placesFile = in.textOr("places", "");
    d.shoreline = readShoreline(in.child("shoreline"));
    d.tide = readTide(in.child("tide"));
    d.elevation = readElevation(in.child("elevation"));
    d.depth = readDepth(in.child("depth"));
    d.shelter = readShelter(in.child("shelter"));
    for (const Node& node : in.listOr("berths")) d.berths.push_back(readBerth(node));
    checkNesting(in, "depth", d.depth.grids, d.box);
    checkNesting(in, "shelter", d.shelter.grids, d.box);
    in.rejectUnknownKeys();
    return d;
}

}  // namespace

core::Result<ImportDescription, core::config::Problems> loadImportDescription(const std::string& name,
                                                                              std::string_view text) {
    core::config::Document document(name, text);
    if (!document.isKind("area-import", kDescriptionVersion)) return document.problems();
    Reader in(document.root());
    ImportDescription d = readAll(in);
    if (document.problems().empty()) d.areaJson = nlohmann::ordered_json::parse(text)["area"].dump();
    return document.finish(std::move(d));
}

}  // namespace sagara::importer
