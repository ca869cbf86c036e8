#include <algorithm>
#include <cmath>

#include "app/tools/CaseRows.h"
#include "app/tools/ReferenceTable.h"
#include "app/tools/VesselChoice.h"
#include "core/base/Units.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/TransferShip.h"

namespace sagara::tools {
namespace {

constexpr double kStep_s = 0.02;

struct TransferCase {
    VesselChoice ship;
    double rudder_deg = 0.0, speed_mps = 0.0;
    double thrust_N = 0.0;  ///< constant
    double mass_kg = 0.0;
    std::string file;
    double position_L = 0.0, heading_deg = 0.0;  ///< largest errors allowed
};

TransferCase readCase(core::config::Reader& in) {
    TransferCase c;
    c.ship.vessel = in.text("vessel");
    c.ship.model = in.text("model");
    c.rudder_deg = in.number("rudder_deg", {-90.0, 90.0, "deg"});
    c.speed_mps = in.number("speed_mps", {0.05, 60.0, "m/s"});
    c.thrust_N = in.number("thrust_N", {0.0, 1e9, "N"});
    c.mass_kg = in.number("mass_kg", {1.0, 1e10, "kg"});
    c.file = in.text("file");
    c.position_L = in.number("position_L", {1e-6, 1.0, ""});
    c.heading_deg = in.number("heading_deg", {1e-4, 90.0, "deg"});
    in.rejectUnknownKeys();
    return c;
}

/// The equations of the model alone: K and tau of the first speed, as published solutions have them.
std::optional<core::TransferModel> equationsOf(const core::Vessel& vessel, const std::string& model) {
    return std::visit(
        [](const auto& parameters) -> std::optional<core::TransferModel> {
            if constexpr (std::is_base_of_v<core::TransferModel, std::decay_t<decltype(parameters)>>) {
                core::TransferModel equations = parameters;
                equations.scalesWithSpeed = false;
                return equations;
            } else {
                return std::nullopt;
            }
        },
        vessel.model(model).value()->parameters);
}

core::ShipMotion rateOf(const core::TransferShip& ship, const core::ShipMotion& x, const TransferCase& c) {
    const core::PlanarAcceleration a =
        ship.acceleration(x, {c.rudder_deg * core::kDegree_rad, {}}, {.surge_N = c.thrust_N});
    core::ShipMotion rate;
    rate.north_m = x.surge_mps * std::cos(x.heading_rad) - x.sway_mps * std::sin(x.heading_rad);
    rate.east_m = x.surge_mps * std::sin(x.heading_rad) + x.sway_mps * std::cos(x.heading_rad);
    rate.heading_rad = x.yawRate_radps;
    rate.surge_mps = a.surge_mps2;
    rate.sway_mps = a.sway_mps2;
    rate.yawRate_radps = a.yaw_radps2;
    return rate;
}

/// Midship and heading at the times of the published solution.
std::vector<core::ShipMotion> runOf(const core::TransferShip& ship, const TransferCase& c,
                                    const ReferenceTable& published) {
    std::vector<core::ShipMotion> run;
    core::ShipMotion m;
    m.surge_mps = c.speed_mps;
    int step = 0;
    for (std::size_t row = 0; row < published.rows(); ++row) {
        const auto until = static_cast<int>(std::lround(published.at("t", row) / kStep_s));
        for (; step < until; ++step)
            m = core::rk4Step(m, kStep_s, [&](const core::ShipMotion& x) { return rateOf(ship, x, c); });
        run.push_back(m);
    }
    return run;
}

void compare(ValidationOutcome& outcome, const std::vector<core::ShipMotion>& run,
             const ReferenceTable& published, const TransferCase& c, double length_m) {
    report::XyPlot plot;
    plot.xTitle = "to starboard, m";
    plot.yTitle = "ahead, m";
    plot.sameScale = true;
    plot.series = {{"Sagara", false, {}}, {"published", true, {}}};
    double worst_m = 0.0, worst_deg = 0.0;
    for (std::size_t row = 0; row < run.size(); ++row) {
        const core::ShipMotion& m = run[row];
        const core::NorthEast place{published.at("x", row), published.at("y", row)};
        worst_m = std::max(worst_m, core::distance(m.position(), place));
        worst_deg =
            std::max(worst_deg, std::abs(m.heading_rad / core::kDegree_rad - published.at("psi", row)));
        plot.series[0].at.emplace_back(m.east_m, m.north_m);
        plot.series[1].at.emplace_back(place.east_m, place.north_m);
    }
    outcome.rows = {
        {.quantity = "track, largest error over L",
         .measured = worst_m / length_m,
         .tolerance = c.position_L},
        {.quantity = "heading, largest error, deg", .measured = worst_deg, .tolerance = c.heading_deg}};
    outcome.plots.push_back(std::move(plot));
}

}  // namespace

/// A turn by the equations of a transfer model, rudder over at once and thrust constant, against a published
/// solution.
ValidationOutcome runTransferCase(const ValidationContext& context, core::config::Reader& in) {
    const TransferCase c = readCase(in);
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    auto opened = openVessel(context.documents, c.ship);
    if (!opened) return outcome.trouble = opened.error(), outcome;
    core::Vessel vessel = std::move(opened).value();
    const auto equations = equationsOf(vessel, c.ship.model);
    if (!equations) return outcome.trouble = c.ship.model + ": is no transfer model", outcome;
    const auto published = ReferenceTable::read(context.reference(c.file));
    if (!published) return outcome.trouble = published.error(), outcome;
    vessel.hull.displacement_m3 = c.mass_kg / vessel.hull.waterDensity_kgpm3;
    compare(outcome, runOf(core::TransferShip(*equations, vessel), c, *published), *published, c,
            vessel.hull.lengthBp_m);
    return outcome;
}

}  // namespace sagara::tools
