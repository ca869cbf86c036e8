#include "core/motion/ShipDynamics.h"

#include <cmath>
#include <type_traits>

#include "core/base/Units.h"
#include "core/motion/SmoothStep.h"
#include "core/motion/Thruster.h"

namespace sagara::core {
namespace {

/// The ship at work for each kind of model.
struct MakeShip {
    const Vessel& vessel;
    ManoeuvringShip operator()(const PolynomialModel& model) const { return PolynomialShip(model, vessel); }
    ManoeuvringShip operator()(const TransferModel& model) const { return TransferShip(model, vessel); }
    ManoeuvringShip operator()(const MmgModel& model) const { return MmgShip(model, vessel); }
};

ManoeuvringShip makeShip(const Vessel& vessel, std::string_view model) {
    return std::visit(MakeShip{vessel}, vessel.model(model).value()->parameters);
}

std::optional<HeightMotion> makeHeightMotion(const Vessel& vessel, std::string_view name) {
    return std::visit(
        [&](const auto& model) -> std::optional<HeightMotion> {
            if constexpr (std::is_base_of_v<TransferModel, std::decay_t<decltype(model)>>)
                if (model.waves == WaveFeeling::Heights || model.waves == WaveFeeling::HeightsPrinted)
                    return HeightMotion(model, vessel);
            return std::nullopt;
        },
        vessel.model(name).value()->parameters);
}

Load mixed(const Load& a, double share, const Load& b) { return share * a + (1.0 - share) * b; }

double criticalDamping(double stiffness, double inertia) { return 2.0 * std::sqrt(stiffness * inertia); }

}  // namespace

WaveLoad::Coefficients ShipDynamics::coefficients(const Vessel& vessel) {
    const Hull& hull = vessel.hull;
    const Seakeeping& s = vessel.seakeeping;
    const double weight_Npm3 = hull.waterDensity_kgpm3 * kGravity_mps2;
    const Waterplane plane = waterplaneOf(hull);
    const double mass_kg = hull.mass_kg(),
                 pitchInertia = mass_kg * hull.pitchGyradius_m * hull.pitchGyradius_m;
    WaveLoad::Coefficients c{};
    c.heaveStiffness = weight_Npm3 * hull.waterplaneArea_m2();
    c.heaveAddedMass = s.heaveAddedMassRatio * mass_kg;
    c.heaveDamping = s.heaveDampingRatio * criticalDamping(c.heaveStiffness, mass_kg + c.heaveAddedMass);
    c.pitchStiffness = weight_Npm3 * plane.breadth_m * std::pow(plane.length_m, 3) / 12.0;
    c.pitchAddedInertia = s.pitchAddedInertiaRatio * pitchInertia;
    c.pitchDamping =
        s.pitchDampingRatio * criticalDamping(c.pitchStiffness, pitchInertia + c.pitchAddedInertia);
    c.rollStiffness = weight_Npm3 * hull.displacement_m3 * hull.metacentricHeight_m;
    return c;
}

ShipDynamics::ShipDynamics(const Vessel& vessel, const WaveTable& waves, std::string_view model)
    : m_model(makeShip(vessel, model)),
      m_holds(vessel.model(model).value()->holds),
      m_heightMotion(makeHeightMotion(vessel, model)),
      m_shafts(vessel.propulsion.units.size()),
      m_headingFollowsRoll(vessel.model(model).value()->headingFollowsRoll),
      m_thrusters(vessel.thrusters),
      m_hull(vessel.hull),
      m_mass_kg(vessel.hull.mass_kg()),
      m_swayMass_kg(m_mass_kg +
                    std::visit([](const auto& ship) { return ship.swayAddedMass_kg(); }, m_model)),
      m_pitchInertia_kgm2(m_mass_kg * vessel.hull.pitchGyradius_m * vessel.hull.pitchGyradius_m),
      m_rollInertia_kgm2(m_mass_kg * vessel.hull.rollGyradius_m * vessel.hull.rollGyradius_m *
                         (1.0 + vessel.seakeeping.rollAddedInertiaRatio)),
      m_rollDamping_Nms(0.0),
      m_c(coefficients(vessel)),
      m_waveLoad(vessel, m_c, waves, wavesOf(vessel.model(model).value()->parameters)) {
    if (m_holds) m_elsewhere = makeShip(vessel, m_holds->elsewhere);
    m_rollDamping_Nms =
        vessel.seakeeping.rollDampingRatio * criticalDamping(m_c.rollStiffness, m_rollInertia_kgm2);
}

HullForces ShipDynamics::hullForces(const ShipMotion& m, const Actuators& actuators, double depth_m) const {
    const auto planar = [](const Load& l) {
        return Load{.surge_N = l.surge_N, .sway_N = l.sway_N, .yaw_Nm = l.yaw_Nm};
    };
    const auto forces = [&](const auto& ship) { return ship.hullForces(m, actuators, depth_m); };
    HullForces f = std::visit(forces, m_model);
    if (const double share = shareOf(m, actuators); share < 1.0) {
        const HullForces other = std::visit(forces, *m_elsewhere);
        f = {mixed(f.hull, share, other.hull), mixed(f.rudder, share, other.rudder),
             mixed(f.propeller, share, other.propeller)};
    }
    return {planar(f.hull), planar(f.rudder),
            planar(f.propeller + thrusterLoad(m_thrusters, m, actuators, m_hull))};
}

double ShipDynamics::shareOf(const ShipMotion& m, const Actuators& actuators) const {
    if (!m_holds) return 1.0;
    double shaft_rps = 0.0;
    for (std::size_t i = 0; i < m_shafts; ++i) shaft_rps += actuators.shaft_rps[i];
    const HoldsIn& h = *m_holds;
    return smoothStep(h.nothingBelow_mps, h.from_mps, m.surge_mps) *
           (1.0 - smoothStep(h.to_mps, h.nothingAbove_mps, m.surge_mps)) *
           smoothStep(0.0, h.shaftFrom_rps * static_cast<double>(m_shafts), shaft_rps);
}

double ShipDynamics::rollOnSpring_radps2(const ShipMotion& m, double heel_Nm) const {
    return (heel_Nm - m_c.rollStiffness * m.roll_rad - m_rollDamping_Nms * m.rollRate_radps) /
           m_rollInertia_kgm2;
}

PlanarAcceleration ShipDynamics::acceleration(const ShipMotion& m, const Actuators& actuators,
                                              const Load& load, double depth_m) const {
    const auto of = [&](const auto& ship) {
        PlanarAcceleration a = ship.acceleration(m, actuators, load, depth_m);
        if (!ship.ownsRoll()) a.roll_radps2 = rollOnSpring_radps2(m, load.roll_Nm + a.heel_Nm);
        return a;
    };
    const double share = shareOf(m, actuators);
    if (share == 1.0) return std::visit(of, m_model);
    const PlanarAcceleration b = std::visit(of, *m_elsewhere);
    if (share == 0.0) return b;
    const PlanarAcceleration a = std::visit(of, m_model);
    const auto mix = [&](double x, double y) { return share * x + (1.0 - share) * y; };
    return {mix(a.surge_mps2, b.surge_mps2), mix(a.sway_mps2, b.sway_mps2), mix(a.roll_radps2, b.roll_radps2),
            mix(a.yaw_radps2, b.yaw_radps2), 0.0};
}

Load ShipDynamics::forceFor(const ShipMotion& m, const ShipMotion& rate, double depth_m) const {
    return std::visit([&](const auto& ship) { return ship.forceFor(m, rate, depth_m); }, m_model);
}

Load ShipDynamics::horizontalForce(const WaveEffect& waves, double depth_m) const {
    ShipMotion rate;
    rate.surge_mps = waves.surge_mps2;
    rate.sway_mps = waves.sway_mps2;
    rate.yawRate_radps = waves.yaw_radps2;
    return forceFor({}, rate, depth_m);
}

ShipMotion ShipDynamics::derivative(const ShipMotion& m, const Actuators& actuators, const Load& external,
                                    const WaveEffect& waves, NorthEast current, double depth_m) const {
    const Load load = external + waves.load + thrusterLoad(m_thrusters, m, actuators, m_hull);
    const PlanarAcceleration a = acceleration(m, actuators, load, depth_m);
    // A model without roll has its sway in the horizontal plane.
    const bool tilted = std::visit([](const auto& ship) { return ship.ownsRoll(); }, m_model);
    const double c = std::cos(m.heading_rad), s = std::sin(m.heading_rad),
                 lateral_mps = tilted ? m.sway_mps * std::cos(m.roll_rad) : m.sway_mps;
    ShipMotion rate;
    rate.north_m = m.surge_mps * c - lateral_mps * s + current.north_m;
    rate.east_m = m.surge_mps * s + lateral_mps * c + current.east_m;
    rate.down_m = m.heaveRate_mps;
    rate.roll_rad = m.rollRate_radps;
    rate.pitch_rad = m.pitchRate_radps;
    rate.heading_rad = m.yawRate_radps * (m_headingFollowsRoll ? std::cos(m.roll_rad) : 1.0);
    rate.surge_mps = a.surge_mps2 + waves.surge_mps2;
    rate.sway_mps = a.sway_mps2 + waves.sway_mps2;
    rate.yawRate_radps = a.yaw_radps2 + waves.yaw_radps2;
    rate.rollRate_radps = a.roll_radps2;
    rate.heaveRate_mps = (load.heave_N - m_c.heaveStiffness * m.down_m - m_c.heaveDamping * m.heaveRate_mps) /
                         (m_mass_kg + m_c.heaveAddedMass);
    rate.pitchRate_radps =
        (load.pitch_Nm - m_c.pitchStiffness * m.pitch_rad - m_c.pitchDamping * m.pitchRate_radps) /
        (m_pitchInertia_kgm2 + m_c.pitchAddedInertia);
    if (m_heightMotion) m_heightMotion->apply(m, load, waves.heights, rate);
    return rate;
}

}  // namespace sagara::core
