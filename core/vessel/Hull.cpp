#include "core/vessel/Hull.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {
namespace {

/// Points along a straight side, its end left out.
void addSide(std::vector<BodyPoint>& outline, BodyPoint from, BodyPoint to) {
    const double length_m = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
    const int pieces = std::max(1, static_cast<int>(std::ceil(length_m / kOutlineStep_m)));
    for (int i = 0; i < pieces; ++i) {
        const double f = static_cast<double>(i) / pieces;
        outline.push_back({from.x_m + f * (to.x_m - from.x_m), from.y_m + f * (to.y_m - from.y_m)});
    }
}

void checkForm(config::Reader& in, const Hull& hull) {
    const double block = hull.blockCoefficient();
    if (block < 0.2 || block > 1.0) {
        in.problem("displacement_m3",
                   "is " + config::formatNumber(hull.displacement_m3) + ", a block coefficient of " +
                       config::formatNumber(std::round(block * 1000.0) / 1000.0) +
                       " with the other particulars",
                   "0.2 to 1");
    }
    if (hull.lengthBp_m > hull.lengthOverall_m) {
        in.problem("lengthBp_m", "is " + config::formatNumber(hull.lengthBp_m),
                   "at most lengthOverall_m, " + config::formatNumber(hull.lengthOverall_m) + " m");
    }
}

}  // namespace

std::vector<BodyPoint> outlineOf(double lengthOverall_m, double beam_m) {
    const double bow = lengthOverall_m / 2.0, half = beam_m / 2.0;
    const double shoulder = bow - 0.3 * lengthOverall_m;
    const double entry = bow - 0.12 * lengthOverall_m;  // where the bow has 60 % of its breadth
    const std::vector<BodyPoint> corners{{bow, 0.0},           {entry, 0.6 * half}, {shoulder, half},
                                         {-bow + half, half},  {-bow, 0.85 * half}, {-bow, -0.85 * half},
                                         {-bow + half, -half}, {shoulder, -half},   {entry, -0.6 * half}};
    std::vector<BodyPoint> outline;
    for (std::size_t i = 0; i < corners.size(); ++i)
        addSide(outline, corners[i], corners[(i + 1) % corners.size()]);
    return outline;
}

Hull readHull(config::Reader& in) {
    Hull h;
    h.lengthOverall_m = in.number("lengthOverall_m", {3.0, 500.0, "m"});
    h.lengthBp_m = in.number("lengthBp_m", {3.0, 500.0, "m"});
    h.beam_m = in.number("beam_m", {1.0, 80.0, "m"});
    h.draught_m = in.number("draught_m", {0.2, 30.0, "m"});
    h.depth_m = in.number("depth_m", {0.5, 60.0, "m"});
    h.displacement_m3 = in.number("displacement_m3", {1.0, 1e6, "m3"});
    h.waterDensity_kgpm3 = in.numberOr("waterDensity_kgpm3", 1025.0, {990.0, 1040.0, "kg/m3"});
    h.metacentricHeight_m = in.number("metacentricHeight_m", {0.05, 30.0, "m"});
    h.waterplaneCoefficient = in.number("waterplaneCoefficient", {0.4, 1.0, ""});
    h.rollGyradius_m = in.number("rollGyradius_m", {0.1, 40.0, "m"});
    h.pitchGyradius_m = in.number("pitchGyradius_m", {0.5, 150.0, "m"});
    if (in.has("bilgeKeelLength_m")) h.bilgeKeelLength_m = in.number("bilgeKeelLength_m", {0.0, 300.0, "m"});
    if (in.has("bilgeKeelBreadth_m")) h.bilgeKeelBreadth_m = in.number("bilgeKeelBreadth_m", {0.0, 2.0, "m"});
    h.stations = readStations(in, h.lengthOverall_m, h.beam_m);
    h.provenance = readProvenance(in);
    if (in.sound()) checkForm(in, h);
    in.rejectUnknownKeys();
    return h;
}

}  // namespace sagara::core
