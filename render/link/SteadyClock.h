#pragma once

#include <chrono>
#include <cstdint>

namespace sagara::link {

/// Microseconds of a clock that never jumps. Of any origin: compare only with itself, or through ClockOffset.
inline std::int64_t steadyClock_us() {
    using namespace std::chrono;
    return duration_cast<microseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace sagara::link
