#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sagara::core {

/// Standards for ship manoeuvrability, IMO resolution MSC.137(76), for a ship of this length between
/// perpendiculars and test speed. They bind ships of 100 m and more and all chemical tankers and gas
/// carriers; smaller ones are compared with them for information.
struct ImoLimits {
    double advance_L = 4.5;
    double tacticalDiameter_L = 5.0;
    double initialTurning_L = 2.5;
    double zigzag10First_deg = 0.0;   ///< by L/V: 10 below 10 s, 20 from 30 s on, between 5 + (L/V)/2
    double zigzag10Second_deg = 0.0;  ///< 25 below 10 s, 40 from 30 s on, between 17.5 + 0.75 (L/V)
    double zigzag20First_deg = 25.0;
    double trackReach_L = 15.0;  ///< 20 at most where a large displacement makes 15 impracticable
};
ImoLimits imoLimits(double lengthBp_m, double speed_mps);
inline constexpr double kImoBindsFrom_m = 100.0;

struct StandardTrials;

/// One criterion against one run.
struct ImoCheck {
    std::string criterion;        ///< "Advance, to starboard"
    std::string unit;             ///< "L" or "deg"
    std::optional<double> value;  ///< none: the ship did not come so far, which is a failure
    double limit = 0.0;
    bool met() const { return value && *value <= limit; }
};
std::vector<ImoCheck> imoChecks(const StandardTrials& trials);

}  // namespace sagara::core
