#include "core/world/Area.h"

#include <algorithm>

namespace sagara::core {

NorthEast Berth::along() const {
    const NorthEast v = face.b - face.a;
    return (1.0 / length(v)) * v;
}

NorthEast Berth::outward() const { return turnedRight(along()); }

double Area::sample(const std::vector<Grid>& grids, NorthEast p) {
    for (const Grid& grid : grids) {
        if (grid.covers(p)) return grid.at(p);
    }
    return grids.back().at(p);
}

bool Area::isLand(NorthEast p) const {
    return std::any_of(land.begin(), land.end(), [&](const auto& ring) { return contains(ring, p); });
}

const Berth* Area::findBerth(std::string_view berthId) const {
    const auto it =
        std::find_if(berths.begin(), berths.end(), [&](const Berth& b) { return b.id == berthId; });
    return it == berths.end() ? nullptr : &*it;
}

const Berth::Bollard* Area::findBollard(std::string_view bollardId) const {
    for (const Berth& berth : berths) {
        for (const Berth::Bollard& bollard : berth.bollards) {
            if (bollard.id == bollardId) return &bollard;
        }
    }
    return nullptr;
}

const Place* Area::findPlace(std::string_view placeId) const {
    const auto it =
        std::find_if(places.begin(), places.end(), [&](const Place& p) { return p.id == placeId; });
    return it == places.end() ? nullptr : &*it;
}

}  // namespace sagara::core
