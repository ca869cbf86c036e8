#include <algorithm>
#include <cmath>

#include "core/seakeeping/Hydrostatics.h"
#include "core/seakeeping/Strips.h"

namespace sagara::core {
namespace {

using Polygon = std::vector<SectionPoint>;

constexpr double kMostFlare = 0.5;  ///< run over rise

/// Whole section up to the deck, the side going on as it meets the water, anticlockwise seen from ahead of a
/// hull with starboard at y > 0.
Polygon wholeSection(const std::vector<SectionPoint>& half, double freeboard_m) {
    const SectionPoint edge = half.back();
    std::size_t below = half.size() - 1;
    while (below > 0 && half[below].z_m > 0.1 * half.front().z_m) --below;
    const double drop_m = edge.z_m - half[below].z_m;
    const double flare =
        drop_m > 0.0 ? std::clamp((edge.y_m - half[below].y_m) / drop_m, 0.0, kMostFlare) : 0.0;
    const double deck_m = edge.y_m + flare * (freeboard_m - edge.z_m);
    Polygon all(half);
    all.push_back({deck_m, freeboard_m});
    all.push_back({-deck_m, freeboard_m});
    for (auto p = half.rbegin(); p != half.rend(); ++p) all.push_back({-p->y_m, p->z_m});
    return all;
}

/// Area of one section below the heeled waterplane and its moment about the vertical plane through the keel's
/// line of reference.
struct Immersed {
    double area_m2 = 0.0;
    double moment_m3 = 0.0;
};

Immersed immersed(const Polygon& section, double heel_rad, double level_m) {
    const double c = std::cos(heel_rad), s = std::sin(heel_rad);
    Polygon wet;  // across, height above the water
    SectionPoint a = section.back();
    a = {a.y_m * c + a.z_m * s, a.z_m * c - a.y_m * s - level_m};
    for (const SectionPoint& p : section) {
        const SectionPoint b{p.y_m * c + p.z_m * s, p.z_m * c - p.y_m * s - level_m};
        if ((a.z_m <= 0.0) != (b.z_m <= 0.0)) {
            const double share = a.z_m / (a.z_m - b.z_m);
            wet.push_back({a.y_m + share * (b.y_m - a.y_m), 0.0});
        }
        if (b.z_m <= 0.0) wet.push_back(b);
        a = b;
    }
    Immersed sum;
    for (std::size_t i = 0; i < wet.size(); ++i) {
        const SectionPoint p = wet[i], q = wet[(i + 1) % wet.size()];
        const double cross_m2 = p.y_m * q.z_m - q.y_m * p.z_m;
        sum.area_m2 += 0.5 * cross_m2;
        sum.moment_m3 += (p.y_m + q.y_m) * cross_m2 / 6.0;
    }
    return sum;
}

}  // namespace

std::vector<RightingLever> rightingLevers(const HullForm& form, const std::vector<double>& heels_rad) {
    std::vector<double> x_m;
    std::vector<Polygon> sections;
    for (const Strip& strip : stripsOf(form)) {
        if (strip.panels.empty()) continue;
        x_m.push_back(strip.x_m);
        sections.push_back(wholeSection(strip.outline, form.freeboard_m));
    }
    const auto under = [&](double heel_rad, double level_m) {
        std::vector<double> area_m2, moment_m3;
        for (const Polygon& section : sections) {
            const Immersed wet = immersed(section, heel_rad, level_m);
            area_m2.push_back(wet.area_m2);
            moment_m3.push_back(wet.moment_m3);
        }
        return Immersed{alongStations(x_m, area_m2, 0), alongStations(x_m, moment_m3, 0)};
    };
    const double volume_m3 = under(0.0, 0.0).area_m2;
    const auto crossCurve_m = [&](double heel_rad) {
        double low_m = -form.draught_m - form.breadth_m, high_m = form.freeboard_m + form.breadth_m;
        for (int i = 0; i < 50; ++i) {
            const double level_m = 0.5 * (low_m + high_m);
            (under(heel_rad, level_m).area_m2 < volume_m3 ? low_m : high_m) = level_m;
        }
        return under(heel_rad, low_m).moment_m3 / volume_m3;
    };
    // The fitted sections begin to heel about a metacentre of their own: by its height they are put right.
    constexpr double kSmall_rad = 0.01;
    const Hydrostatics h = hydrostaticsOf(form);
    const double metacentre_m = h.buoyancyHeight_m + h.transverseBM_m - form.draught_m;
    const double off_m = metacentre_m - crossCurve_m(kSmall_rad) / std::sin(kSmall_rad);
    std::vector<RightingLever> levers;
    for (const double heel_rad : heels_rad) {
        const double gravity_m = form.gravityHeight_m - form.draught_m;
        levers.push_back({heel_rad, crossCurve_m(heel_rad) + (off_m - gravity_m) * std::sin(heel_rad)});
    }
    return levers;
}

}  // namespace sagara::core
