#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/exercise/Snapshot.h"

namespace sagara::ui {

/// What the classroom watches of an own ship.
enum class Trace { Surge, Sway, Heave, Roll, Pitch, Yaw, Drift, SpeedKept };
inline constexpr std::size_t kTraces = 8;

/// The watched values in time, in the units people read: knots, metres, degrees, degrees a minute, per cent.
/// What has no value (drift of a ship at rest, speed kept on a straight course) is a NaN.
class TraceSeries {
public:
    struct Sample {
        double time_s = 0.0;
        std::array<double, kTraces> values{};
    };

    /// Once for each moment; an earlier one than the last begins afresh, as after going back.
    void add(double time_s, const core::ShipMotion& motion);
    void clear();
    const std::vector<Sample>& samples() const { return m_samples; }
    /// Speed through the water before the present turn, m/s; none when she goes straight.
    std::optional<double> speedBefore_mps() const { return m_turning ? m_speedBefore : std::nullopt; }

    static constexpr double kLongest_s = 900.0;

private:
    double speedKept_percent(double passed_s, const core::ShipMotion& motion);

    std::vector<Sample> m_samples;
    std::optional<double> m_speedBefore;  ///< mean of a while, for waves make it go up and down
    double m_meanTurn_radps = 0.0;        ///< likewise
    bool m_turning = false;
};

}  // namespace sagara::ui
