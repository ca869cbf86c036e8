#include "core/identify/TrialTrip.h"

#include <algorithm>
#include <cmath>

#include "core/base/Config.h"
#include "core/base/Units.h"
#include "core/identify/TrialShip.h"
#include "core/vessel/Estimate.h"

namespace sagara::core {
namespace {

constexpr double kHeldShare = 0.97;     ///< of the ordered revolutions, to count as held
constexpr double kLeastFriction = 0.5;  ///< planing boats lift half of their bottom out
constexpr double kMostOfWeight = 0.45;  ///< resistance; planing boats have 0.15 to 0.25
constexpr double kSlowestFroude = 0.05;
constexpr double kFastest_mps = 60.0 * kKnot_mps;

/// The fastest ships of a length, by Froude number: planing boats to liners.
double fastestFroude(double length_m) { return 0.6 + 2.5 * std::exp(-length_m / 30.0); }

/// Three figures.
std::string figure(double value) {
    if (value == 0.0) return "0";
    const double scale = std::pow(10.0, 2.0 - std::floor(std::log10(std::abs(value))));
    return config::formatNumber(std::round(value * scale) / scale);
}
std::string knots(double speed_mps) { return figure(speed_mps / kKnot_mps) + " kn"; }
std::string kilonewtons(double force_N) { return figure(1e-3 * force_N) + " kN"; }
std::string rpm(double speed_rps) { return figure(speed_rps / kRpm_rps); }

class Trip {
public:
    Trip(config::Problems& problems, const Vessel& vessel, const NamedModel& model, std::string path)
        : m_problems(problems),
          m_vessel(vessel),
          m_path(std::move(path)),
          m_name(model.name),
          m_ship(vessel, model.name) {}

    void sail() {
        m_full_rps = order(TelegraphStep::FullAhead);
        m_full_mps = m_ship.steadyAt(m_full_rps).speed_mps;
        if (!m_ship.finite())
            return say(m_path, "does not stay finite at full ahead", "a model that settles");
        const bool usual =
            m_name == m_vessel.models.front().name;  // others may hold for a part of her speeds
        if (usual) checkSpeed();
        if (usual) checkEngines();
        if (usual && !thrustAndResistanceAreOne()) checkResistance();
        checkWheel();
        checkAstern();
    }

private:
    double order(TelegraphStep step) const {
        return m_vessel.propulsion.telegraph_rps[static_cast<std::size_t>(step)];
    }
    void say(const std::string& path, std::string found, std::string expected) {
        m_problems.add({path, std::move(found), std::move(expected)});
    }
    const Hull& hull() const { return m_vessel.hull; }
    double froude_mps() const { return std::sqrt(kGravity_mps2 * hull().lengthBp_m); }

    /// Straight ahead with all shafts as ordered, whatever the engines have.
    HullForces ahead(double speed_mps) const {
        Actuators actuators;
        actuators.shaft_rps.fill(m_full_rps);
        ShipMotion motion;
        motion.surge_mps = speed_mps;
        return m_ship.dynamics().hullForces(motion, actuators);
    }

    /// Some published sets hold both in their rows.
    bool thrustAndResistanceAreOne() const {
        const auto* set = std::get_if<PolynomialModel>(&m_vessel.model(m_name).value()->parameters);
        return set && set->balanced;
    }

    void checkSpeed() {
        const double least_mps = kSlowestFroude * froude_mps(),
                     most_mps = std::min(kFastest_mps, fastestFroude(hull().lengthBp_m) * froude_mps());
        if (m_full_mps >= least_mps && m_full_mps <= most_mps) return;
        say("propulsion.telegraph_rpm.fullAhead",
            "is " + rpm(m_full_rps) + ", " + knots(m_full_mps) + " (model " + m_name + ", thrust at rest " +
                kilonewtons(ahead(0.0).propeller.surge_N) + ", resistance at that speed " +
                kilonewtons(-ahead(m_full_mps).hull.surge_N) + ")",
            "a speed of " + knots(least_mps) + " to " + knots(most_mps) + " for a length of " +
                figure(hull().lengthBp_m) + " m");
    }

    void checkEngines() {
        for (std::size_t i = 0; i < m_vessel.propulsion.units.size(); ++i) {
            const PropulsionUnit& unit = m_vessel.propulsion.units[i];
            const double reached_rps = m_ship.state().shafts[i].speed_rps,
                         wanted_rps = demandOf(unit, m_ship.state().shafts[i]).speed_rps;
            if (!unit.engine || reached_rps >= kHeldShare * wanted_rps) continue;
            std::string path = "propulsion.units";
            say(path.append("[").append(std::to_string(i)).append("].engine"),
                "gives " + figure(1e-3 * unit.engine->torque_Nm) + " kN m, enough for " + rpm(reached_rps) +
                    " rpm and " + knots(m_full_mps),
                "torque for full ahead, " + rpm(wanted_rps) + " rpm");
        }
    }

    void checkResistance() {
        estimate::Form form{};
        form.length_m = hull().lengthBp_m;
        form.draught_m = hull().draught_m;
        form.volume_m3 = hull().displacement_m3;
        const double resistance_N = -ahead(m_full_mps).hull.surge_N,
                     least_N = kLeastFriction * estimate::frictionalResistance_N(form, m_full_mps),
                     most_N = kMostOfWeight * hull().mass_kg() * kGravity_mps2;
        if (resistance_N >= least_N && resistance_N <= most_N) return;
        say(m_path, "gives a resistance of " + kilonewtons(resistance_N) + " at " + knots(m_full_mps),
            kilonewtons(least_N) + ", half the friction of the hull, to " + kilonewtons(most_N) +
                ", 0.45 of her weight");
    }

    void checkWheel() {
        m_ship.begin({m_full_mps, m_full_rps});
        m_ship.orderRudder(std::min(20.0 * kDegree_rad, m_vessel.steering.limit_rad));
        const double turn_s = 3.0 * hull().lengthBp_m / std::max(m_full_mps, 0.1);
        run(turn_s + m_vessel.steering.limit_rad / m_vessel.steering.rate_radps);
        if (!m_ship.finite())
            say(m_path, "does not stay finite in a turn", "a model that settles");
        else if (m_ship.motion().yawRate_radps <= 0.0)
            say(m_path,
                "turns her to port, " + figure(m_ship.motion().yawRate_radps / kDegree_rad) +
                    " deg/s, with the wheel to starboard",
                "rudder and derivatives of one sign convention: starboard wheel, starboard turn");
    }

    void checkAstern() {
        m_ship.begin({});
        m_ship.orderShafts(order(TelegraphStep::FullAstern));
        run(60.0);
        if (!m_ship.finite())
            say(m_path, "does not stay finite astern", "a model that settles");
        else if (m_ship.motion().surge_mps > -1e-3)
            say("propulsion.telegraph_rpm.fullAstern",
                "is " + rpm(order(TelegraphStep::FullAstern)) + " and gives no way astern, " +
                    figure(m_ship.motion().surge_mps) + " m/s ahead after a minute",
                "thrust astern");
    }

    void run(double duration_s) {
        constexpr double kStep_s = 0.1;
        const double end_s = m_ship.state().time_s + duration_s;
        while (m_ship.state().time_s < end_s && m_ship.finite()) m_ship.step(kStep_s);
    }

    config::Problems& m_problems;
    const Vessel& m_vessel;
    std::string m_path, m_name;
    TrialShip m_ship;
    double m_full_rps = 0.0, m_full_mps = 0.0;
};

}  // namespace

config::Problems problemsAtSea(const std::string& name, const Vessel& vessel) {
    config::Problems problems(name);
    for (std::size_t i = 0; i < vessel.models.size() && problems.empty(); ++i) {
        std::string path = "models";
        path.append("[").append(std::to_string(i)).append("]");
        Trip(problems, vessel, vessel.models[i], vessel.models.size() == 1 ? "model" : path).sail();
    }
    return problems;
}

Result<Vessel, config::Problems> loadSeaworthy(const std::string& name, std::string_view text) {
    auto vessel = loadVessel(name, text);
    if (!vessel) return vessel;
    if (auto problems = problemsAtSea(name, *vessel); !problems.empty()) return problems;
    return vessel;
}

}  // namespace sagara::core
