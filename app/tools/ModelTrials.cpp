#include "app/tools/ModelTrials.h"

#include <cmath>

#include "app/run/Console.h"
#include "app/tools/Manoeuvre.h"
#include "core/base/Units.h"
#include "core/identify/TrialShip.h"

namespace sagara::tools {
namespace {

constexpr double kDrift_rad = 5.0 * core::kDegree_rad;

ManoeuvreOptions optionsFor(ManoeuvreOptions::Test test, const std::string& model, double speed_mps,
                            double rudder_deg) {
    ManoeuvreOptions o;
    o.ship.model = model;
    o.test = test;
    o.speed_mps = speed_mps;
    o.rudder_deg = rudder_deg;
    return o;
}

std::optional<double> ratio(const core::Trial& trial, const core::Trial& over) {
    const auto a = trial.measure("tactical_diameter_over_L"), b = over.measure("tactical_diameter_over_L");
    return a && b ? std::optional(*a / *b) : std::nullopt;
}

double speedLeft(const core::Vessel& vessel, const std::string& model, double speed_mps) {
    core::TrialShip ship(vessel, model);
    ship.begin(ship.holding(speed_mps));
    ship.orderShafts(0.0);
    const double end_s = 10.0 * vessel.hull.lengthBp_m / speed_mps;
    while (ship.motion().surge_mps > 0.0 && ship.state().time_s < end_s) ship.step(0.1);
    return ship.motion().surge_mps / speed_mps;
}

double yawFromDrift(const core::Vessel& vessel, const std::string& model, double speed_mps) {
    core::TrialShip ship(vessel, model);
    ship.begin(ship.holding(speed_mps));
    core::Actuators actuators;
    for (std::size_t i = 0; i < vessel.propulsion.units.size(); ++i)
        actuators.shaft_rps[i] = ship.state().shafts[i].speed_rps;
    core::ShipMotion m;
    m.surge_mps = speed_mps * std::cos(kDrift_rad);
    const auto yaw = [&](double sway_mps) {
        m.sway_mps = sway_mps;
        return ship.dynamics().derivative(m, actuators, {}, {}).yawRate_radps;
    };
    const double drift_mps = speed_mps * std::sin(kDrift_rad);
    const double unit = std::pow(speed_mps / vessel.hull.lengthBp_m, 2);
    return 0.5 * (yaw(drift_mps) - yaw(-drift_mps)) / unit;  // without what the propeller does by itself
}

}  // namespace

ModelTrials runModelTrials(const std::string& name, const core::Vessel& vessel, const std::string& model,
                           const ModelTask& task, const std::shared_ptr<const core::SeaHull>& hull) {
    using Test = ManoeuvreOptions::Test;
    ModelTrials t;
    t.name = name;
    t.length_m = vessel.hull.lengthBp_m;
    ManoeuvreOptions turn = optionsFor(Test::Turning, model, task.speed_mps, task.rudder_deg);
    const double start_s = run::wallClock_s();
    t.turn = tryManoeuvre(vessel, turn);
    const double took_s = std::max(1e-6, run::wallClock_s() - start_s);
    if (!t.turn.samples.empty()) t.timesRealTime = t.turn.samples.back().time_s / took_s;
    t.turnPort = tryManoeuvre(vessel, optionsFor(Test::Turning, model, task.speed_mps, -task.rudder_deg));
    t.zigzag = tryManoeuvre(vessel, optionsFor(Test::Zigzag, model, task.speed_mps, task.zigzag_deg));
    t.halfSpeedDiameter =
        ratio(tryManoeuvre(vessel, optionsFor(Test::Turning, model, 0.5 * task.speed_mps, task.rudder_deg)),
              t.turn);
    turn.ship.depth_m = task.shallowDepthOverDraught * vessel.hull.draught_m;
    t.shallowDiameter = ratio(tryManoeuvre(vessel, turn), t.turn);
    t.speedLeft = speedLeft(vessel, model, task.speed_mps);
    t.yawFromDrift = yawFromDrift(vessel, model, task.speed_mps);
    const core::ShipDynamics ship(vessel, model, hull);
    for (const double omega_radps : task.omegas_radps) {
        const double lambda_m = core::kTwoPi * core::kGravity_mps2 / (omega_radps * omega_radps);
        t.waves.push_back({omega_radps, lambda_m / t.length_m,
                           answerToWave(ship, omega_radps, core::kPi, task.waveAmplitude_m),
                           answerToWave(ship, omega_radps, 0.5 * core::kPi, task.waveAmplitude_m)});
    }
    return t;
}

}  // namespace sagara::tools
