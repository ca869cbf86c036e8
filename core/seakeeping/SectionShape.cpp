#include "core/seakeeping/SectionShape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace sagara::core {
namespace {

using Line = std::vector<SectionPoint>;
constexpr double kPi = std::numbers::pi;
constexpr int kFinePoints = 400;
constexpr double kSkegArea = 6.0 / 7.0, kSkegMoment = 3.0 / 8.0;  ///< of 1 - t^6 over t = 0 to 1

/// Half breadth as a function of the depth over the draught, closed along the bottom.
Line lineOf(double draught_m, const std::function<double(double)>& halfBreadth_m) {
    Line line{{0.0, -draught_m}};
    for (int i = 0; i <= kFinePoints; ++i) {
        const double depth = 0.5 * (1.0 + std::cos(kPi * i / kFinePoints));
        const double y_m = std::max(0.0, halfBreadth_m(depth));
        if (i == 0 && y_m <= 0.0) continue;
        line.push_back({y_m, -depth * draught_m});
    }
    return line;
}

std::optional<Line> roundedBox(const SectionData& d, int panels) {
    const double missing_m2 = 2.0 * d.halfBreadth_m * d.draught_m - d.area_m2;
    const double radius_m = std::sqrt(std::max(0.0, missing_m2) / (2.0 - 0.5 * kPi));
    if (d.fullness() < 0.85 || d.fullness() > 1.005 || radius_m > std::min(d.halfBreadth_m, d.draught_m))
        return std::nullopt;
    // Nodes of the flats gather at both of their ends, where the potential bends most.
    const double flat_m = d.halfBreadth_m - radius_m, side_m = d.draught_m - radius_m,
                 arc_m = 0.5 * kPi * radius_m;
    const double total_m = flat_m + side_m + arc_m;
    const int arc =
        radius_m > 0.01 * d.draught_m ? std::max(2, static_cast<int>(panels * arc_m / total_m)) : 0;
    const int bottom = std::max(2, static_cast<int>((panels - arc) * flat_m / (flat_m + side_m) + 0.5));
    const int side = panels - arc - bottom;
    if (side < 2 || flat_m <= 0.0 || side_m <= 0.0) return std::nullopt;
    const double corner_m = arc > 0 ? radius_m : 0.0;
    Line line;
    for (int i = 0; i <= bottom; ++i)
        line.push_back({(d.halfBreadth_m - corner_m) * std::sin(0.5 * kPi * i / bottom), -d.draught_m});
    for (int i = 1; i <= arc; ++i) {
        const double turn = 0.5 * kPi * i / arc;
        line.push_back({d.halfBreadth_m - corner_m * (1.0 - std::sin(turn)),
                        -d.draught_m + corner_m * (1.0 - std::cos(turn))});
    }
    for (int i = 1; i <= side; ++i)
        line.push_back({d.halfBreadth_m, -0.5 * (d.draught_m - corner_m) * (1.0 + std::cos(kPi * i / side))});
    return line;
}

/// b (a (1 - t)^p + (1 - a)(1 - t^6)) over the depth t: p and a from area and centroid, by halving.
std::optional<Line> skeg(const SectionData& d, int panels) {
    const double area = d.fullness(), moment = area * d.centroidDepth_m / d.draught_m;
    if (!(area > 0.02 && area < kSkegArea)) return std::nullopt;
    const auto share = [&](double p) { return (kSkegArea - area) / (kSkegArea - 1.0 / (p + 1.0)); };
    const auto momentAt = [&](double p) {
        return share(p) / ((p + 1.0) * (p + 2.0)) + (1.0 - share(p)) * kSkegMoment;
    };
    double low = std::max(1.0 / area - 1.0, 0.2), high = 60.0;
    if (moment < momentAt(low) || moment > momentAt(high)) return std::nullopt;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (momentAt(middle) < moment ? low : high) = middle;
    }
    const double a = share(low), p = low;
    return resampled(lineOf(d.draught_m,
                            [&](double t) {
                                return d.halfBreadth_m *
                                       (a * std::pow(1.0 - t, p) + (1.0 - a) * (1.0 - std::pow(t, 6.0)));
                            }),
                     panels);
}

/// A wedge from the waterline to the keel and an ellipse that stands on the keel.
std::optional<Line> bulb(const SectionData& d, int panels) {
    const double wedge_m2 = d.halfBreadth_m * d.draught_m, lobe_m2 = d.area_m2 - wedge_m2;
    if (lobe_m2 <= 0.0) return std::nullopt;
    const double depth_m = (d.area_m2 * d.centroidDepth_m - wedge_m2 * d.draught_m / 3.0) / lobe_m2;
    const double half_m = d.draught_m - depth_m;  // height of the ellipse
    if (half_m < 0.08 * d.draught_m || half_m > 0.5 * d.draught_m) return std::nullopt;
    const double reach_m = lobe_m2 / (kPi * half_m);
    return resampled(lineOf(d.draught_m,
                            [&](double t) {
                                const double above = (t * d.draught_m - depth_m) / half_m;
                                const double lobe = reach_m * std::sqrt(std::max(0.0, 1.0 - above * above));
                                return d.halfBreadth_m * (1.0 - t) + lobe;
                            }),
                     panels);
}

/// Breadth, draught and area by a power of the depth.
Line plain(const SectionData& d, int panels) {
    const double area = std::clamp(d.halfBreadth_m > 0.0 ? d.fullness() : 1.0, 0.05, 0.98);
    const double b_m = d.halfBreadth_m;
    if (area < 0.5)
        return resampled(
            lineOf(d.draught_m, [&](double t) { return b_m * std::pow(1.0 - t, 1.0 / area - 1.0); }), panels);
    return resampled(
        lineOf(d.draught_m, [&](double t) { return b_m * (1.0 - std::pow(t, area / (1.0 - area))); }),
        panels);
}

/// A section wholly under water, where only its area and the depth of its centroid count.
Line submerged(const SectionData& d, int panels) {
    const double half_m = std::max(d.draught_m - d.centroidDepth_m, 0.1 * d.draught_m);
    const double height_m = std::min(half_m, 0.98 * d.centroidDepth_m);
    Line line;
    for (int i = 0; i <= panels; ++i) {
        const double turn = kPi * i / panels;
        line.push_back(
            {d.area_m2 / (kPi * height_m) * std::sin(turn), -d.centroidDepth_m - height_m * std::cos(turn)});
    }
    line.front().y_m = line.back().y_m = 0.0;
    return line;
}

bool hasCentroid(const Line& line, const SectionData& d) {
    const SectionArea found = areaOf(panelsOf(line));
    return std::abs(found.depth_m - d.centroidDepth_m) < kCentroidBand * d.draught_m;
}

}  // namespace

const char* nameOf(SectionFit fit) {
    switch (fit) {
        case SectionFit::Lewis:
            return "a Lewis form";
        case SectionFit::RoundedBox:
            return "a flat bottom, round bilge and wall side";
        case SectionFit::Skeg:
            return "an upper hull over a skeg";
        case SectionFit::Bulb:
            return "a wedge over a bulb";
        case SectionFit::Plain:
            break;
    }
    return "a plain form";
}

std::vector<SectionPoint> resampled(const std::vector<SectionPoint>& line, int panels) {
    const std::vector<SectionPanel> pieces = panelsOf(line);
    double length_m = 0.0, before = 0.0;
    for (const SectionPanel& p : pieces) length_m += p.length_m;
    std::vector<double> measure{0.0};
    std::vector<SectionPoint> ends{pieces.front().from};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double direction = std::atan2(-pieces[i].normalZ, pieces[i].normalY);
        const double turn = i > 0 ? std::abs(std::remainder(direction - before, 2.0 * kPi)) : 0.0;
        before = direction;
        measure.push_back(measure.back() + pieces[i].length_m / length_m + 0.2 * std::min(turn, 0.1));
        ends.push_back(pieces[i].to);
    }
    std::vector<SectionPoint> nodes;
    std::size_t at = 1;
    for (int i = 0; i <= panels; ++i) {
        const double wanted = measure.back() * i / panels;
        while (at + 1 < measure.size() && measure[at] < wanted) ++at;
        const double share =
            std::clamp((wanted - measure[at - 1]) / (measure[at] - measure[at - 1]), 0.0, 1.0);
        const SectionPoint a = ends[at - 1], b = ends[at];
        nodes.push_back({a.y_m + share * (b.y_m - a.y_m), a.z_m + share * (b.z_m - a.z_m)});
    }
    return nodes;
}

std::vector<SectionPoint> thickened(std::vector<SectionPoint> nodes) {
    const double keel_m = -nodes.front().z_m;
    for (SectionPoint& p : nodes) {
        const double depth = -p.z_m / keel_m;
        const double least_m = 0.05 * keel_m * std::min({1.0, depth / 0.15, 8.0 * (1.0 - depth)});
        p.y_m = std::max(p.y_m, least_m);
    }
    return nodes;
}

std::optional<std::vector<SectionPoint>> lewisSection(const SectionData& d, int panels) {
    if (d.halfBreadth_m <= 0.0 || d.draught_m <= 0.0 || d.area_m2 <= 0.0) return std::nullopt;
    const double ratio = (d.halfBreadth_m - d.draught_m) / (d.halfBreadth_m + d.draught_m);
    const double fullness = 4.0 / kPi * d.fullness();
    const double c = 3.0 + fullness + (1.0 - fullness) * ratio * ratio;
    if (9.0 - 2.0 * c < 0.0) return std::nullopt;
    const double a3 = (3.0 - c + std::sqrt(9.0 - 2.0 * c)) / c;
    const double a1 = ratio * (1.0 + a3);
    const double scale_m = d.halfBreadth_m / (1.0 + a1 + a3);
    std::vector<SectionPoint> nodes;
    for (int i = 0; i <= panels; ++i) {
        const double t = 0.5 * kPi * i / panels;
        nodes.push_back({scale_m * ((1.0 + a1) * std::sin(t) - a3 * std::sin(3.0 * t)),
                         -scale_m * ((1.0 - a1) * std::cos(t) + a3 * std::cos(3.0 * t))});
    }
    nodes.front().y_m = 0.0;
    nodes.back().z_m = 0.0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const bool inside = nodes[i].y_m > 0.0 && nodes[i].y_m < 1.01 * d.halfBreadth_m &&
                            nodes[i].z_m <= 1e-9 && nodes[i].z_m >= -1.01 * d.draught_m &&
                            nodes[i].z_m > nodes[i - 1].z_m - 0.005 * d.draught_m;
        if (!inside) return std::nullopt;
    }
    return nodes;
}

SectionShape shapeOf(const SectionData& d, int panels) {
    if (d.halfBreadth_m < 1e-3 * d.draught_m && d.centroidDepth_m > 0.0)
        return {SectionFit::Plain, submerged(d, panels)};
    if (const auto box = roundedBox(d, panels); box && d.fullness() > 0.995)
        return {SectionFit::RoundedBox, *box};
    const std::array<std::pair<SectionFit, std::optional<Line>>, 4> fits{
        {{SectionFit::Lewis, lewisSection(d, panels)},
         {SectionFit::RoundedBox, roundedBox(d, panels)},
         {SectionFit::Skeg, skeg(d, panels)},
         {SectionFit::Bulb, bulb(d, panels)}}};
    for (const auto& [fit, line] : fits)
        if (line && hasCentroid(*line, d)) return {fit, *line};
    if (fits[0].second) return {SectionFit::Lewis, *fits[0].second};
    return {SectionFit::Plain, plain(d, panels)};
}

}  // namespace sagara::core
