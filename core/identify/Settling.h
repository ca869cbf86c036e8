#pragma once

namespace sagara::core {

class TrialShip;

/// Watches for a steady yaw rate: its mean over one length run differs from that of the length before by less
/// than a thousandth. At the earliest after 4 lengths, at the latest after 80.
class Settling {
public:
    Settling(const TrialShip& ship, double lengthTime_s);
    /// After each step; true when she is steady.
    bool settled(const TrialShip& ship, double step_s);
    double yawRate_radps() const { return m_mean_radps; }  ///< mean over the last whole length

private:
    double m_begun_s;
    double m_from_s;
    double m_lengthTime_s;
    double m_sum_rad = 0.0;
    double m_mean_radps = 0.0;
};

}  // namespace sagara::core
