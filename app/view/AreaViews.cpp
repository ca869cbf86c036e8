#include "app/view/AreaViews.h"

#include <numbers>

namespace sagara::view {
namespace {

using core::NorthEast;
using render::shoreCamera;

constexpr double kEye_m = 10.0;  ///< height of a small ship's bridge

/// The point at that distance with the deepest water around it: where ships would come from.
NorthEast seawardOf(const core::Area& area, NorthEast place, double distance_m) {
    constexpr int kBearings = 24;
    NorthEast best = place;
    double deepest_m = -1e9;
    for (int i = 0; i < kBearings; ++i) {
        const NorthEast way = core::unitVector(2.0 * std::numbers::pi * i / kBearings);
        // The water on the way counts as well: no headland may hide the place.
        double shallowest_m = area.depth_m(place + distance_m * way);
        for (const double share : {0.3, 0.5, 0.7})
            shallowest_m = std::min(shallowest_m, area.depth_m(place + share * distance_m * way));
        if (shallowest_m > deepest_m) deepest_m = shallowest_m, best = place + distance_m * way;
    }
    return best;
}

}  // namespace

std::vector<AreaView> viewsOf(const core::Area& area, const render::Lens& lens) {
    std::vector<AreaView> views;
    const core::Place* entrance = nullptr;
    for (const core::Place& place : area.places) {
        if (place.kind == "entrance") {
            if (entrance == nullptr) entrance = &place;
            views.push_back({place.id, shoreCamera(seawardOf(area, place.position, 550.0), kEye_m,
                                                   place.position, 6.0, lens)});
        } else if (place.kind == "fort") {
            views.push_back({place.id, shoreCamera(seawardOf(area, place.position, 800.0), kEye_m,
                                                   place.position, 12.0, lens)});
        } else if (place.kind == "anchorage") {
            views.push_back({place.id, shoreCamera(place.position, kEye_m,
                                                   entrance ? entrance->position : NorthEast{}, 10.0, lens)});
        }
    }
    for (const core::Mark& mark : area.marks) {
        if (mark.kind != core::MarkKind::Lighthouse || !mark.light) continue;
        views.push_back(
            {"light-" + mark.id, shoreCamera(seawardOf(area, mark.position, 800.0), kEye_m, mark.position,
                                             mark.light->height_m, lens.magnified(7.0))});
    }
    const NorthEast middle = entrance ? entrance->position : NorthEast{};
    views.push_back({"air", shoreCamera(seawardOf(area, middle, 1500.0), 400.0, middle, 0.0, lens)});
    return views;
}

}  // namespace sagara::view
