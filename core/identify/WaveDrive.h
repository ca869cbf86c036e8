#pragma once

#include <array>
#include <vector>

#include "core/identify/SeaTrial.h"
#include "core/vessel/Hull.h"

namespace sagara::core {

/// What a measured wave asks of one motion of a ship (roll, pitch or heave), worked out of the surface at
/// midship frequency by frequency: the slope across or along her, or the height, each averaged over a box of
/// her waterplane at half her draught, in deep water. With its rates, and once more a quarter of a period
/// later, so that sums of both have any phase.
class WaveDrive {
public:
    /// `log`: a motion log. `fastest_radps`: faster encounters are left out; she does not answer them.
    WaveDrive(const SeaTrial& log, Channel motion, const Hull& hull, double fastest_radps);

    /// Height in m or slope in rad, first and second rate; straight between the log's rows.
    using Values = std::array<double, 3>;
    Values inPhase(double time_s) const { return at(m_inPhase, time_s); }
    Values aQuarterLater(double time_s) const { return at(m_later, time_s); }

private:
    Values at(const std::vector<Values>& series, double time_s) const;

    double m_from_s, m_step_s;
    std::vector<Values> m_inPhase, m_later;
};

/// Wave number of a wave that is met at a frequency, deep water; `heading_rad` less the waves' direction. Of
/// the three waves that a ship running before them meets at one frequency, the longest.
double encounteredWaveNumber_radpm(double encounter_radps, double speed_mps, double heading_rad);

}  // namespace sagara::core
