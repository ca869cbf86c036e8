#pragma once

#include "core/motion/ShipMotion.h"
#include "core/seakeeping/RadiationMemory.h"

namespace sagara::core {

/// An own ship's motion and what the water about her remembers of it. The same type holds rates.
struct MovingShip {
    ShipMotion motion;
    MemoryState water{};
};

inline MovingShip operator+(const MovingShip& a, const MovingShip& b) {
    MovingShip sum{a.motion + b.motion, {}};
    for (std::size_t i = 0; i < kMemoryValues; ++i) sum.water[i] = a.water[i] + b.water[i];
    return sum;
}
inline MovingShip operator*(double s, const MovingShip& a) {
    MovingShip product{s * a.motion, {}};
    for (std::size_t i = 0; i < kMemoryValues; ++i) product.water[i] = s * a.water[i];
    return product;
}

}  // namespace sagara::core
