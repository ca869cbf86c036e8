#pragma once

#include <cstdint>

namespace sagara::core {

/// Noise of a sensor that is the same whenever the picture is made again: uniform in [0, 1) by a hash of the
/// place in the picture (the finaliser of SplitMix64).
inline double sensorNoise(std::uint32_t seed, std::uint32_t a, std::uint32_t b) {
    std::uint64_t z = (static_cast<std::uint64_t>(seed) << 40) ^ (static_cast<std::uint64_t>(a) << 20) ^ b;
    z += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
}

}  // namespace sagara::core
