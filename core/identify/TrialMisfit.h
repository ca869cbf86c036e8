#pragma once

#include <span>

#include "core/identify/TrialReplay.h"

namespace sagara::core {

/// How a ship differs from a trial, channel by channel, in units of what a good trial can measure: position
/// 0.02 L, heading 1 deg, speeds 2 % of the approach, yaw rate 2 % of U/L, roll 0.5 deg; a spiral's rudder
/// 0.5 deg. These only say how channels count against each other: the fit finds out how large misfits are.
class TrialMisfit {
public:
    TrialMisfit(const SeaTrial& trial, double length_m);

    /// One for each number in the record.
    std::size_t measurements() const { return m_measurements; }
    /// For how many they count: one in each channel and length run.
    double independent() const { return m_independent; }
    /// False: she left the numbers.
    bool operator()(ReplayShip& ship, const TrialStart& start, std::span<double> out) const;

    /// Root mean squares of the differences, in the units of ShipMotion, position over the length; none where
    /// the record has no such channel.
    struct Rms {
        std::optional<double> position_L, heading_rad, speed_mps, yawRate_radps, roll_rad, rudder_rad;
    };
    Rms rms(ReplayShip& ship, const TrialStart& start) const;

private:
    struct Watched {
        Channel channel;
        double deviation;
    };
    bool rows(const ReplayShip& ship, std::span<double> out) const;

    const SeaTrial& m_trial;
    std::vector<Watched> m_watched;
    std::size_t m_measurements = 0;
    double m_independent = 0.0;
};

}  // namespace sagara::core
