#include "app/import/CoastSource.h"

#include <algorithm>
#include <limits>

#include "app/import/GeoLayer.h"

namespace sagara::importer {
namespace {

using core::LocalFrame;
using core::NorthEast;
using core::ShoreKind;
using core::config::Problems;

std::vector<GeoRing> readRings(const std::filesystem::path& file, Problems& problems) {
    std::vector<GeoRing> rings;
    for (GeoFeature& feature : readGeoLayer(file, GeoShape::Polygon, problems)) {
        for (auto& part : feature.parts) rings.push_back(std::move(part));
    }
    return rings;
}

std::string namesOf(const std::vector<ShorelineRules::Category>& categories) {
    std::string all;
    for (const auto& c : categories) all += (all.empty() ? "" : ", ") + c.name;
    return all;
}

ShoreKind kindOf(const GeoFeature& feature, const ShorelineRules& rules, Problems& problems) {
    const std::string category = feature.property("category");
    for (const auto& known : rules.categories) {
        if (known.name == category) return known.kind;
    }
    problems.add({feature.path + ".category", "is \"" + category + "\"",
                  "one of " + namesOf(rules.categories) + " (shoreline.categories of the description)"});
    return ShoreKind::Other;
}

std::vector<CoastLine> readLines(const std::filesystem::path& file, const ShorelineRules& rules,
                                 Problems& all) {
    Problems problems(file.filename().string());
    std::vector<CoastLine> lines;
    for (GeoFeature& feature : readGeoLayer(file, GeoShape::Line, all)) {
        const ShoreKind kind = kindOf(feature, rules, problems);
        for (auto& part : feature.parts) lines.push_back({kind, feature.property("name"), std::move(part)});
    }
    if (!problems.empty()) all.append(problems);
    return lines;
}

std::vector<NorthEast> local(const std::vector<core::GeoPoint>& points, const LocalFrame& frame) {
    std::vector<NorthEast> list;
    list.reserve(points.size());
    for (const core::GeoPoint p : points) list.push_back(frame.toLocal(p));
    return list;
}

double distance_m(const std::vector<NorthEast>& line, NorthEast p) {
    double best_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.size(); ++i)
        best_m = std::min(best_m, distanceTo({line[i - 1], line[i]}, p));
    return best_m;
}

void correct(std::vector<CoastLine>& lines, const ShorelineRules::Correction& correction) {
    const LocalFrame about(correction.near);
    const auto nearer = [&](const CoastLine& a, const CoastLine& b) {
        return distance_m(local(a.points, about), {}) < distance_m(local(b.points, about), {});
    };
    const auto line = std::min_element(lines.begin(), lines.end(), nearer);
    if (line == lines.end()) return;
    line->kind = correction.kind;
    if (!correction.name.empty()) line->name = correction.name;
}

std::vector<Ring> local(const std::vector<GeoRing>& rings, const LocalFrame& frame) {
    std::vector<Ring> list;
    for (const GeoRing& ring : rings) list.push_back(local(ring, frame));
    return list;
}

/// Sides of the context rings with an end beyond the box, each a line of its own.
void addBeyond(std::vector<core::ShoreLine>& lines, const GeoRing& ring, const GeoBox& box,
               const LocalFrame& frame) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        if (box.contains(ring[i]) && box.contains(ring[j])) continue;
        lines.push_back({ShoreKind::Other, "", {frame.toLocal(ring[j]), frame.toLocal(ring[i])}});
    }
}

}  // namespace

bool isWorks(ShoreKind kind) {
    return kind == ShoreKind::Quay || kind == ShoreKind::Jetty || kind == ShoreKind::Breakwater;
}

Coast readCoast(const ImportDescription& description, const std::filesystem::path& folder,
                Problems& problems) {
    Coast coast;
    coast.land = readRings(folder / description.landFile, problems);
    coast.context = readRings(folder / description.contextFile, problems);
    coast.lines = readLines(folder / description.shoreline.file, description.shoreline, problems);
    for (const auto& correction : description.shoreline.corrections) correct(coast.lines, correction);
    return coast;
}

LocalCoast localCoast(const Coast& coast, const GeoBox& box, const LocalFrame& frame) {
    LocalCoast made;
    made.land = local(coast.land, frame);
    made.context = local(coast.context, frame);
    std::vector<core::ShoreLine> all, natural;
    for (const CoastLine& line : coast.lines) {
        all.push_back({line.kind, line.name, local(line.points, frame)});
        if (!isWorks(line.kind)) natural.push_back(all.back());
    }
    for (const GeoRing& ring : coast.context) addBeyond(natural, ring, box, frame);
    // Neither is asked on which side the water is, so neither needs the land.
    made.shore = core::Shore(std::move(all), {});
    made.natural = core::Shore(std::move(natural), {});
    return made;
}

}  // namespace sagara::importer
