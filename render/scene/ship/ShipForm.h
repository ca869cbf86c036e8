#pragma once

#include <array>
#include <optional>

#include "core/vessel/Vessel.h"
#include "core/world/Target.h"
#include "render/scene/shape/Solid.h"

namespace sagara::render {

/// What a ship looks like when there is no 3D model of her: chosen by her type.
enum class ShipStyle { Patrol, Fishing, Coaster, Tanker, Container, Ferry, Yacht, Tug, FastCraft };

/// Where a model has its lights, by core::LightPlace; none: where they usually are.
using LightPoints = std::array<std::optional<Point>, core::kLightPlaces>;

/// Size and fullness of a ship to be drawn. x from midship, heights above her waterline.
struct ShipForm {
    ShipStyle style = ShipStyle::Coaster;
    double length_m = 50.0;
    double beam_m = 9.0;
    double draught_m = 3.0;
    double freeboard_m = 2.0;  ///< waterline to main deck amidships
    double block = 0.6;
    double bridge_m = 0.0;        ///< x of the wheelhouse front
    double bridgeHeight_m = 8.0;  ///< of eyes in it
    LightPoints lights;
    std::vector<core::HullStation> stations;  ///< none: the hull follows from the numbers above

    double deckAt_m(double x_m) const;  ///< height of the deck with its sheer
    double bow_m() const { return 0.5 * length_m; }
};

ShipForm formOf(const core::Vessel& vessel);
ShipForm formOf(const core::TargetLayout& target);

}  // namespace sagara::render
