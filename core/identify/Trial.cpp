#include "core/identify/Trial.h"

#include <array>
#include <cmath>

#include "core/base/Config.h"
#include "core/base/Units.h"

namespace sagara::core {

std::optional<double> Trial::measure(std::string_view name) const {
    for (const TrialMeasure& m : measures)
        if (m.name == name) return m.value;
    return std::nullopt;
}

std::string trialCsv(const Trial& trial) {
    const auto rounded = [](double v) { return config::formatNumber(std::round(v * 1e6) / 1e6); };
    std::string text =
        "time_s,x_m,y_m,heading_deg,surge_mps,sway_mps,yaw_rate_degps,roll_deg,rudder_deg,shaft_rps\n";
    for (const TrialSample& s : trial.samples) {
        const std::array values{s.time_s,
                                s.x_m,
                                s.y_m,
                                s.heading_rad / kDegree_rad,
                                s.surge_mps,
                                s.sway_mps,
                                s.yawRate_radps / kDegree_rad,
                                s.roll_rad / kDegree_rad,
                                s.rudder_rad / kDegree_rad,
                                s.shaft_rps};
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (i > 0) text += ',';
            text += rounded(values[i]);
        }
        text += '\n';
    }
    return text;
}

}  // namespace sagara::core
