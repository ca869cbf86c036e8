#pragma once

#include <compare>
#include <cstdint>

namespace sagara::core {

/// Integer microseconds since scenario start. There is no other clock in core.
struct SimTime {
    std::int64_t us = 0;

    static constexpr SimTime fromSeconds(std::int64_t s) { return {s * 1'000'000}; }
    constexpr double seconds() const { return static_cast<double>(us) * 1e-6; }
    friend constexpr auto operator<=>(const SimTime&, const SimTime&) = default;
    /// Of two moments. Compare durations this way: differences of `seconds()` are rounded.
    friend constexpr SimTime operator-(SimTime a, SimTime b) { return {a.us - b.us}; }
};

/// One step of a running exercise: 20 ms, always.
inline constexpr std::int64_t kTick_us = 20'000;
inline constexpr double kTick_s = 0.02;
inline constexpr std::int64_t kTicksPerSecond = 1'000'000 / kTick_us;

inline constexpr SimTime timeOfTick(std::int64_t tick) { return {tick * kTick_us}; }

}  // namespace sagara::core
