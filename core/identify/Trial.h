#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a standard manoeuvre gives: a record of the ship and the measures people compare ships by. Plain
/// data.
namespace sagara::core {

/// One moment. x along the approach course from where the order was given, y to its right; the rest as in
/// ShipMotion. Midship, calm water.
struct TrialSample {
    double time_s = 0.0;
    double x_m = 0.0;
    double y_m = 0.0;
    double heading_rad = 0.0;
    double surge_mps = 0.0;
    double sway_mps = 0.0;
    double yawRate_radps = 0.0;
    double roll_rad = 0.0;
    double rudder_rad = 0.0;
    double shaft_rps = 0.0;  ///< mean of the shafts
    double heave_m = 0.0;    ///< downward
    double pitch_rad = 0.0;
};

struct TrialMeasure {
    std::string name;  ///< with its unit: "advance_over_L", "overshoot_1_deg", "t90_s"
    double value = 0.0;
};

enum class TrialEnd {
    Completed,
    Cancelled,
    TimedOut,  ///< the ship did not get there; what was measured until then stands
    NotFinite  ///< the model left the numbers
};

struct Trial {
    std::string title;  ///< "Turning circle, 35 deg to starboard"
    double length_m = 0.0;
    double approach_mps = 0.0;
    std::vector<TrialSample> samples;
    std::vector<TrialMeasure> measures;
    TrialEnd end = TrialEnd::Completed;

    /// Nothing where the ship did not come so far.
    std::optional<double> measure(std::string_view name) const;
};

/// Steady ahead before the order.
struct Approach {
    double speed_mps = 0.0;
    double shaft_rps = 0.0;
};

struct TrialOptions {
    std::optional<Approach> approach;   ///< none: full ahead by telegraph, steady
    double step_s = 0.02;               ///< one tick of an exercise
    std::optional<double> sample_s;     ///< none: a fiftieth of a length run
    std::optional<double> duration_s;   ///< none: as long as the measures need
    std::function<bool(double)> watch;  ///< told the share done, 0 to 1; false cancels
};

/// "time_s,x_m,y_m,heading_deg,surge_mps,sway_mps,yaw_rate_degps,roll_deg,rudder_deg,shaft_rps" and a row for
/// every sample.
std::string trialCsv(const Trial& trial);

}  // namespace sagara::core
