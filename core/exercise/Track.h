#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/assess/Observation.h"
#include "core/base/Archive.h"
#include "core/exercise/State.h"

namespace sagara::core {

/// Samples of the kinematic track are taken five times a second, when the assessment looks too.
inline constexpr std::int64_t kTrackEvery_ticks = 10;

/// One own ship in the track: how she lies, what her machinery does, and the observation she is graded by.
struct ShipSample {
    ShipMotion motion;  ///< rates of roll, pitch and heave are not kept
    double rudder_rad = 0.0;
    std::array<double, kMostShafts> shafts_rps{};
    double score = 100.0;
    Observation observation;
};

struct TargetSample {
    bool present = false;
    NorthEast position;
    double heading_rad = 0.0;
    double speed_mps = 0.0;
};

struct TrackSample {
    std::int64_t tick = 0;
    std::vector<ShipSample> ships;
    std::vector<TargetSample> targets;
};

TrackSample sampleOf(const World& world, const State& state);

/// Writes samples as differences of rounded values in as few bytes as they need, and reads them back.
/// Rounding: 1 cm, 1 mm/s, 0.006 deg. Writer and reader begin afresh at every State of a recording, so that
/// each stretch reads by itself.
class TrackCodec {
public:
    void restart() { m_last.clear(); }
    void encode(const TrackSample& sample, Bytes& out);
    /// Takes one sample off the front of `bytes`; false when they are damaged. `ships` and `targets` as in
    /// the exercise.
    bool decode(std::span<const std::byte>& bytes, std::size_t ships, std::size_t targets,
                TrackSample& sample);

private:
    std::vector<std::int64_t> m_last;
};

}  // namespace sagara::core
