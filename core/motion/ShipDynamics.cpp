#include "core/motion/ShipDynamics.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/base/Units.h"
#include "core/motion/SmoothStep.h"
#include "core/motion/Thruster.h"
#include "core/vessel/Metacentre.h"

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

/// A share of the critical, as measured or fitted, less what the tables' radiated waves have of it.
ViscousRoll rollDampingOf(double ratio, const SeaHull& hull) {
    const double omega = hull.rollFrequency_radps;
    if (omega <= 0.0) return {};
    const double all_Nms = 2.0 * ratio * hull.restoring(3, 3) / omega;
    return {std::max(0.0, all_Nms - hull.memory.radiationAt(omega).damping(3, 3)), 0.0};
}

}  // namespace

ShipDynamics::Springs::Springs(const Vessel& vessel) {
    const Hull& hull = vessel.hull;
    const Seakeeping& s = vessel.seakeeping;
    const double weight_Npm3 = hull.waterDensity_kgpm3 * kGravity_mps2, mass_kg = hull.mass_kg();
    const Waterplane plane = waterplaneOf(hull);
    heaveMass = mass_kg * (1.0 + s.heaveAddedMassRatio);
    heaveStiffness = weight_Npm3 * hull.waterplaneArea_m2();
    heaveDamping = s.heaveDampingRatio * criticalDamping(heaveStiffness, heaveMass);
    pitchInertia = mass_kg * hull.pitchGyradius_m * hull.pitchGyradius_m * (1.0 + s.pitchAddedInertiaRatio);
    pitchStiffness = weight_Npm3 * plane.breadth_m * std::pow(plane.length_m, 3) / 12.0;
    pitchDamping = s.pitchDampingRatio * criticalDamping(pitchStiffness, pitchInertia);
    rollInertia = mass_kg * hull.rollGyradius_m * hull.rollGyradius_m * (1.0 + s.rollAddedInertiaRatio);
    rollStiffness = weight_Npm3 * hull.displacement_m3 * hull.metacentricHeight_m;
    rollDamping = s.rollDampingRatio * criticalDamping(rollStiffness, rollInertia);
}

ShipDynamics::ShipDynamics(const Vessel& vessel, std::string_view model, std::shared_ptr<const SeaHull> hull)
    : m_model(makeShip(vessel, model)),
      m_holds(vessel.model(model).value()->holds),
      m_heightMotion(makeHeightMotion(vessel, model)),
      m_shafts(vessel.propulsion.units.size()),
      m_headingFollowsRoll(vessel.model(model).value()->headingFollowsRoll),
      m_instantaneousHull(vessel.seakeeping.instantaneousHull),
      m_thrusters(vessel.thrusters),
      m_hull(vessel.hull),
      m_waterplane(waterplaneOf(vessel.hull)),
      m_mass_kg(vessel.hull.mass_kg()),
      m_swayMass_kg(m_mass_kg +
                    std::visit([](const auto& ship) { return ship.swayAddedMass_kg(); }, m_model)),
      m_gravityDepth_m(gravityDepth_m(vessel.hull)),
      m_springs(vessel) {
    if (m_holds) m_elsewhere = makeShip(vessel, m_holds->elsewhere);
    if (vessel.planing) m_planing.emplace(*vessel.planing, vessel.hull);
    if (hull && wavesOf(vessel.model(model).value()->parameters) == WaveFeeling::Pressure)
        takeToSea(vessel, std::move(hull));
}

bool ShipDynamics::ownsRoll() const {
    return std::visit([](const auto& ship) { return ship.ownsRoll(); }, m_model);
}

void ShipDynamics::takeToSea(const Vessel& vessel, std::shared_ptr<const SeaHull> hull) {
    std::optional<ViscousRoll> damping;
    if (vessel.seakeeping.provenance.quality != Quality::Estimated)
        damping = rollDampingOf(vessel.seakeeping.rollDampingRatio, *hull);
    m_sea.emplace(std::move(hull), ownsRoll(), damping);
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

PlanarAcceleration ShipDynamics::acceleration(const ShipMotion& m, const Actuators& actuators,
                                              const Load& load, double depth_m) const {
    const auto of = [&](const auto& ship) {
        PlanarAcceleration a = ship.acceleration(m, actuators, load, depth_m);
        if (ship.ownsRoll()) return a;
        if constexpr (!std::is_same_v<std::decay_t<decltype(ship)>, MmgShip>) {
            // Knows no heel: the side force of the water is what turns her.
            const double side_N = m_mass_kg * (a.sway_mps2 + m.surge_mps * m.yawRate_radps) - load.sway_N;
            a.heelAtBo_Nm = -kLateralForceDepth * m_hull.draught_m * side_N;
            a.heel_Nm = a.heelAtBo_Nm + m_gravityDepth_m * side_N;
        }
        a.roll_radps2 = (load.roll_Nm + a.heel_Nm - m_springs.rollStiffness * m.roll_rad -
                         m_springs.rollDamping * m.rollRate_radps) /
                        m_springs.rollInertia;
        return a;
    };
    const double share = shareOf(m, actuators);
    if (share == 1.0) return std::visit(of, m_model);
    const PlanarAcceleration b = std::visit(of, *m_elsewhere);
    if (share == 0.0) return b;
    const PlanarAcceleration a = std::visit(of, m_model);
    const auto mix = [&](double x, double y) { return share * x + (1.0 - share) * y; };
    return {mix(a.surge_mps2, b.surge_mps2),   mix(a.sway_mps2, b.sway_mps2),
            mix(a.roll_radps2, b.roll_radps2), mix(a.yaw_radps2, b.yaw_radps2),
            mix(a.heel_Nm, b.heel_Nm),         mix(a.heelAtBo_Nm, b.heelAtBo_Nm)};
}

Load ShipDynamics::forceFor(const ShipMotion& m, const ShipMotion& rate, double depth_m) const {
    return std::visit([&](const auto& ship) { return ship.forceFor(m, rate, depth_m); }, m_model);
}

WaveEffect ShipDynamics::wavesAt(const ActiveWaves& waves, const ShipMotion& m, double shelter) const {
    WaveEffect effect;
    if (m_sea) {
        const SeaHull& hull = m_sea->hull();
        effect.forces = hull.excitation.force(waves, m.position(), m.heading_rad, m.surge_mps, shelter);
        if (m_instantaneousHull) {
            const Six more = hull.wetted.correction(
                waves, {m.position(), m.heading_rad, m.down_m, m.roll_rad, m.pitch_rad}, shelter);
            effect.wetted = {.heave_N = more[2], .roll_Nm = more[3], .pitch_Nm = more[4]};
        }
    }
    if (m_heightMotion) {
        const WaveHeights h = waveHeights(m_waterplane, waves, m.position(), m.heading_rad);
        effect.heights = {shelter * h.sum_m3, shelter * h.along_m3, shelter * h.across_m3};
    }
    return effect;
}

ShipMotion ShipDynamics::kinematics(const ShipMotion& m, NorthEast current) const {
    const double c = std::cos(m.heading_rad), s = std::sin(m.heading_rad);
    // A model without roll has its sway in the horizontal plane.
    const double lateral_mps = ownsRoll() ? m.sway_mps * std::cos(m.roll_rad) : m.sway_mps;
    ShipMotion rate;
    rate.north_m = m.surge_mps * c - lateral_mps * s + current.north_m;
    rate.east_m = m.surge_mps * s + lateral_mps * c + current.east_m;
    rate.down_m = m.heaveRate_mps;
    rate.roll_rad = m.rollRate_radps;
    rate.pitch_rad = m.pitchRate_radps;
    rate.heading_rad = m.yawRate_radps * (m_headingFollowsRoll ? std::cos(m.roll_rad) : 1.0);
    return rate;
}

ShipMotion ShipDynamics::onSprings(const ShipMotion& m, const Actuators& actuators, const Load& external,
                                   const WaveHeights& heights, NorthEast current, double depth_m) const {
    const Load load = external + thrusterLoad(m_thrusters, m, actuators, m_hull);
    const PlanarAcceleration a = acceleration(m, actuators, load, depth_m);
    const Springs& s = m_springs;
    const RunningAttitude running = m_planing ? m_planing->at(m.surge_mps) : RunningAttitude();
    ShipMotion rate = kinematics(m, current);
    rate.surge_mps = a.surge_mps2;
    rate.sway_mps = a.sway_mps2;
    rate.yawRate_radps = a.yaw_radps2;
    rate.rollRate_radps = a.roll_radps2;
    rate.heaveRate_mps =
        (load.heave_N - s.heaveStiffness * (m.down_m - running.down_m) - s.heaveDamping * m.heaveRate_mps) /
        s.heaveMass;
    rate.pitchRate_radps = (load.pitch_Nm - s.pitchStiffness * (m.pitch_rad - running.pitch_rad) -
                            s.pitchDamping * m.pitchRate_radps) /
                           s.pitchInertia;
    if (m_heightMotion) m_heightMotion->apply(m, load, heights, rate);
    return rate;
}

ShipMotion ShipDynamics::derivative(const ShipMotion& m, const Actuators& actuators, const Load& external,
                                    NorthEast current, double depth_m) const {
    return onSprings(m, actuators, external, {}, current, depth_m);
}

ShipMotion ShipDynamics::throughWater(const ShipMotion& m, const WaveForces& waves) const {
    ShipMotion relative = m;
    if (!m_sea) return relative;
    relative.surge_mps -= waves.waterSurge_mps;
    relative.sway_mps -= waves.waterSway_mps;
    relative.roll_rad -= m_sea->effectiveHeel_rad(waves);
    return relative;
}

MovingShip ShipDynamics::derivative(const MovingShip& ship, const Actuators& actuators, const Load& external,
                                    const WaveEffect& waves, NorthEast current, double depth_m) const {
    const ShipMotion& m = ship.motion;
    if (!m_sea) return {onSprings(m, actuators, external, waves.heights, current, depth_m), {}};
    const ShipMotion relative = throughWater(m, waves.forces);
    Load load = external + waves.wetted + meanForce(waves.forces) +
                thrusterLoad(m_thrusters, relative, actuators, m_hull);
    if (m_planing) {
        const RunningAttitude running = m_planing->at(m.surge_mps);
        load = load + m_sea->holding(running.down_m, running.pitch_rad, m.surge_mps);
    }
    const SeaMotion::Rate at =
        m_sea->rate(ship, acceleration(relative, actuators, load, depth_m), load, waves.forces);
    MovingShip rate{kinematics(m, current), at.water};
    rate.motion.surge_mps = at.acceleration[0];
    rate.motion.sway_mps = at.acceleration[1];
    rate.motion.heaveRate_mps = at.acceleration[2];
    rate.motion.rollRate_radps = at.acceleration[3];
    rate.motion.pitchRate_radps = at.acceleration[4];
    rate.motion.yawRate_radps = at.acceleration[5];
    return rate;
}

}  // namespace sagara::core
