#pragma once

#include <cstdint>

#include "core/motion/Load.h"
#include "core/motion/ShipMotion.h"
#include "core/vessel/DeckGear.h"

namespace sagara::core {

enum class AnchorStatus : std::uint8_t {
    Home,     ///< in the hawse
    Running,  ///< let go: brake off, cable runs out
    Held,     ///< brake on
    Veering,  ///< cable is let out under control
    Heaving,  ///< windlass heaves in
    CableParted
};
const char* anchorStatusName(AnchorStatus status);

struct AnchorState {
    AnchorStatus status = AnchorStatus::Home;
    bool onBottom = false;
    double cableOut_m = 0.0;  ///< from the hawse
    double stopAt_m = 0.0;    ///< brake goes on when this much is out, or in
    NorthEast position;       ///< of the anchor once on the bottom
    double set = 0.0;         ///< 0 to 1: how far the flukes have dug in
    double dragSpeed_mps = 0.0;
    double dragged_m = 0.0;  ///< over the ground since it last came to it
    double pull_N = 0.0;     ///< horizontal, on the ship, in this tick
    double hawseTension_N = 0.0;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.status, self.onBottom, self.cableOut_m, self.stopAt_m, self.position, self.set,
           self.dragSpeed_mps, self.dragged_m, self.pull_N, self.hawseTension_N);
    }
};

/// What the ground and the water are like under the anchor.
struct AnchorGround {
    double depth_m = 0.0;       ///< water, tide included
    double holdingRatio = 1.0;  ///< of the area
};

/// Of its cable in water, and EA of it.
double cableWeight_Npm(const AnchorGear& gear);
double cableStiffness_N(const AnchorGear& gear);

/// Most horizontal pull the anchor and the cable that lies can take before they move. Anchor: holding factor
/// times weight, a third of it before the flukes have dug in, less by 1/15 for every degree of uplift, half
/// when it is dragged faster than 0.5 m/s. Cable on the ground: friction of its own weight.
double holdingPower_N(const AnchorGear& gear, const AnchorState& anchor, const AnchorGround& ground,
                      double lying_m, double uplift_rad);

/// Works the anchor for one tick after the ship has moved: cable, bottom, tension, dragging. Returns true
/// when the cable parts in this tick.
bool workAnchor(const AnchorGear& gear, AnchorState& anchor, const AnchorGround& ground, const ShipMotion& m,
                double dt_s);

/// Load of the cable on the ship, from the pull worked out in the last tick.
Load anchorLoad(const AnchorGear& gear, const AnchorState& anchor, const ShipMotion& m);

}  // namespace sagara::core
