#include "app/import/BerthPlan.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/Config.h"

namespace sagara::importer {
namespace {

using core::NorthEast;

constexpr double kFaceTolerance_m = 1.0;  ///< the survey's points lie up to 0.5 m off a straight face
constexpr double kProbe_m = 3.0;          ///< off the face, to see which side is land

/// Distances from one end, evenly and with equal rests at both ends, no rest below a quarter of the spacing.
std::vector<double> spread_m(double length_m, double spacing_m) {
    const double count = std::max(1.0, std::floor((length_m - 0.5 * spacing_m) / spacing_m) + 1.0);
    const double first_m = 0.5 * (length_m - (count - 1.0) * spacing_m);
    std::vector<double> all_m;
    for (int i = 0; i < static_cast<int>(count); ++i) all_m.push_back(first_m + i * spacing_m);
    return all_m;
}

std::string numbered(const std::string& prefix, std::size_t number) {
    char text[16];
    std::snprintf(text, sizeof text, "-%02zu", number);
    return prefix + text;
}

/// The face in frame N with its own axes.
struct Face {
    NorthEast a, b;
    double length_m;
    NorthEast along;
    NorthEast outward;
    NorthEast at(double along_m, double outward_m) const { return a + along_m * along + outward_m * outward; }
};

Face faceOf(const BerthRules& rules, const core::LocalFrame& frame) {
    const NorthEast a = frame.toLocal(rules.a), b = frame.toLocal(rules.b);
    const double length_m = distance(a, b);
    const NorthEast along = (1.0 / std::max(length_m, 1e-9)) * (b - a);
    return {a, b, length_m, along, turnedRight(along)};
}

bool onLand(const LocalCoast& coast, NorthEast p) {
    return std::any_of(coast.land.begin(), coast.land.end(),
                       [&](const Ring& ring) { return contains(ring, p); });
}

double farthestOff_m(const Face& face, const LocalCoast& coast) {
    double worst_m = 0.0;
    for (double s_m = 0.0; s_m <= face.length_m; s_m += 1.0) {
        worst_m = std::max(worst_m, coast.shore.distance_m(face.at(s_m, 0.0), 1000.0));
    }
    return worst_m;
}

}  // namespace

BerthPlan planBerth(const BerthRules& rules, const core::LocalFrame& frame) {
    const Face face = faceOf(rules, frame);
    BerthPlan plan;
    std::size_t number = 0;
    for (const double s_m : spread_m(face.length_m, rules.bollardSpacing_m)) {
        const double fromA_m = rules.numberedFromB ? face.length_m - s_m : s_m;
        plan.bollards.push_back(
            {numbered(rules.bollardPrefix, ++number), face.at(fromA_m, -rules.bollardSetback_m)});
    }
    for (const double s_m : spread_m(face.length_m, rules.fenderSpacing_m))
        plan.fenders.push_back(face.at(s_m, 0.0));
    return plan;
}

void checkFace(const BerthRules& rules, const LocalCoast& coast, const core::LocalFrame& frame,
               const std::string& path, core::config::Problems& problems) {
    const Face face = faceOf(rules, frame);
    const double off_m = farthestOff_m(face, coast);
    if (off_m > kFaceTolerance_m) {
        problems.add({path + ".a",
                      "to b runs up to " + core::config::formatNumber(std::round(off_m * 10.0) / 10.0) +
                          " m off the shoreline",
                      "a face at most 1 m off it"});
        return;
    }
    const double middle_m = 0.5 * face.length_m;
    if (onLand(coast, face.at(middle_m, kProbe_m)) || !onLand(coast, face.at(middle_m, -kProbe_m))) {
        problems.add(
            {path + ".a", "to b has the land on its right hand", "the water on the right hand from a to b"});
    }
}

}  // namespace sagara::importer
