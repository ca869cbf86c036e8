#pragma once

#include "render/scene/shape/Solid.h"
#include "render/scene/ship/ShipForm.h"

namespace sagara::render {

struct HullPaint {
    Paint bottom{0.36, 0.10, 0.08};
    Paint side{0.55, 0.58, 0.60};
    Paint deck{0.36, 0.40, 0.38};
};

/// Shell, transom, deck and bulwark of a ship: through the stations of her document where it has them, else
/// through stations worked out from her main particulars.
Solid hullSurface(const ShipForm& form, const HullPaint& paint);

/// Closes the hull at the top of its bulwark: what lies below it, inside, is not the sea.
Solid hullLid(const ShipForm& form);

/// Half breadth of the deck at x, to stand things on it.
double deckHalfBreadth_m(const ShipForm& form, double x_m);

}  // namespace sagara::render
