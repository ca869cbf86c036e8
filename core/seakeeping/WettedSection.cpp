#include "core/seakeeping/WettedSection.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {
namespace {

constexpr double kMostFlare = 0.5;  ///< run over rise

}  // namespace

SectionPolygon wholeSection(const std::vector<SectionPoint>& half, double freeboard_m) {
    const SectionPoint edge = half.back();
    std::size_t below = half.size() - 1;
    while (below > 0 && half[below].z_m > 0.1 * half.front().z_m) --below;
    const double drop_m = edge.z_m - half[below].z_m;
    const double flare =
        drop_m > 0.0 ? std::clamp((edge.y_m - half[below].y_m) / drop_m, 0.0, kMostFlare) : 0.0;
    const double deck_m = edge.y_m + flare * (freeboard_m - edge.z_m);
    SectionPolygon all(half);
    all.push_back({deck_m, freeboard_m});
    all.push_back({-deck_m, freeboard_m});
    for (auto p = half.rbegin(); p != half.rend(); ++p) all.push_back({-p->y_m, p->z_m});
    return all;
}

WettedSection wettedSection(const SectionPolygon& section, double heel_rad, double level_m) {
    const double c = std::cos(heel_rad), s = std::sin(heel_rad);
    const auto turned = [&](const SectionPoint& p) {
        return SectionPoint{p.y_m * c + p.z_m * s,
                            p.z_m * c - p.y_m * s - level_m};  // across, above the plane
    };
    WettedSection sum;
    SectionPoint first, last;
    bool any = false;
    const auto add = [&](const SectionPoint& q) {
        if (any) {
            const double cross_m2 = last.y_m * q.z_m - q.y_m * last.z_m;
            sum.area_m2 += 0.5 * cross_m2;
            sum.moment_m3 += (last.y_m + q.y_m) * cross_m2 / 6.0;
        } else {
            first = q;
            any = true;
        }
        last = q;
    };
    SectionPoint a = turned(section.back());
    for (const SectionPoint& p : section) {
        const SectionPoint b = turned(p);
        if ((a.z_m <= 0.0) != (b.z_m <= 0.0)) {
            const double share = a.z_m / (a.z_m - b.z_m);
            add({a.y_m + share * (b.y_m - a.y_m), 0.0});
        }
        if (b.z_m <= 0.0) add(b);
        a = b;
    }
    if (any) add(first);
    return sum;
}

}  // namespace sagara::core
