#pragma once

#include <string>

#include "core/identify/SeaTrial.h"
#include "core/identify/Trial.h"

namespace sagara::test {

/// Normally distributed, of mean 0 and deviation 1, the same for the same seed.
class Noise {
public:
    explicit Noise(std::uint64_t seed);
    double operator()();

private:
    std::uint64_t m_seed;
};

/// A run as a good trial would record it: position to 0.01 L, heading 0.3 deg, speeds 0.05 m/s, yaw rate 0.01
/// deg/s, roll 0.2 deg. By way of its CSV. `header`: lines such as "# kind: turning\n".
core::SeaTrial recorded(const core::Trial& run, const std::string& header, Noise& noise);

}  // namespace sagara::test
