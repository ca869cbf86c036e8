#pragma once

#include "core/world/Area.h"

namespace sagara::core::test {

/// Water of one depth, without shore.
inline Area openWater(double depth_m) {
    Area area;
    area.depths.push_back(
        Grid({-5000.0, -5000.0}, 10'000.0, 2, 2, std::vector<float>(4, static_cast<float>(depth_m))));
    return area;
}

/// Open water with land; all of its coast is of one kind.
inline Area withLand(std::vector<std::vector<NorthEast>> rings, ShoreKind kind = ShoreKind::Quay) {
    Area area = openWater(20.0);
    std::vector<ShoreLine> lines;
    for (const auto& ring : rings) {
        lines.push_back({kind, "", ring});
        lines.back().points.push_back(ring.front());
    }
    area.land = std::move(rings);
    area.shore = Shore(std::move(lines), area.land);
    return area;
}

/// A quay along the whole of north = 0, with the land to the south of it.
inline Area longQuay(ShoreKind kind = ShoreKind::Quay) {
    return withLand({{{0.0, -3000.0}, {0.0, 3000.0}, {-500.0, 3000.0}, {-500.0, -3000.0}}}, kind);
}

/// That quay with fenders every `spacing_m` from -100 to 100 m east, 0.9 m thick.
inline Area fenderedQuay(double spacing_m, double stiffness_Npm) {
    Area area = longQuay();
    Berth berth;
    berth.id = "long-quay";
    berth.face = {{0.0, 100.0}, {0.0, -100.0}};  // water on the right: north
    for (double east_m = -100.0; east_m <= 100.0; east_m += spacing_m) {
        berth.fenders.push_back({{0.0, east_m}, 0.9, 1.2, stiffness_Npm});
    }
    area.berths.push_back(berth);
    return area;
}

}  // namespace sagara::core::test
