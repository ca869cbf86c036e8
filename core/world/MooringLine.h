#pragma once

#include <cstdint>

#include "core/motion/Load.h"
#include "core/motion/ShipMotion.h"
#include "core/vessel/DeckGear.h"

namespace sagara::core {

enum class LineStatus : std::uint8_t {
    In,        ///< aboard
    Fast,      ///< on the bollard, length held
    Slacking,  ///< on the bollard, being paid out
    Heaving,   ///< on the bollard, being hove in as far as the winch can pull
    CastOff,   ///< off the bollard, being hauled in
    Parted     ///< broken; does nothing any more
};
const char* lineStatusName(LineStatus status);

struct LineState {
    LineStatus status = LineStatus::In;
    double length_m = 0.0;  ///< unstretched, fairlead to bollard; while CastOff what is still outboard
    double tension_N = 0.0;

    bool onBollard() const {
        return status == LineStatus::Fast || status == LineStatus::Slacking || status == LineStatus::Heaving;
    }
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.status, self.length_m, self.tension_N);
    }
};

/// A line of the exercise: which fairlead, which bollard.
struct LineLayout {
    BodyPoint fairlead;
    NorthEast bollard;
};

/// Tension of an elastic line, never negative: EA (d - L) / L, with damping of the stretch's growth.
double lineTension_N(const MooringGear& gear, const LineState& line, double distance_m,
                     double stretchRate_mps);

/// Load on the ship of one line at a motion inside the tick; its length and status do not change in it.
/// `current`: of the water, because motion is through it.
Load lineLoad(const MooringGear& gear, const LineLayout& layout, const LineState& line, const ShipMotion& m,
              NorthEast current);

/// Works the line for one tick, after the ship has moved. Returns true when it parts in this tick.
bool workLine(const MooringGear& gear, const LineLayout& layout, LineState& line, const ShipMotion& m,
              double dt_s);

/// Made fast with a little tension where the ship lies.
LineState madeFast(const LineLayout& layout, const ShipMotion& m);

}  // namespace sagara::core
