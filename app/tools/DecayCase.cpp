#include <algorithm>
#include <cmath>

#include "app/tools/ReferenceTable.h"
#include "app/tools/ValidationCase.h"
#include "app/tools/VesselChoice.h"
#include "core/base/Units.h"
#include "core/identify/Decay.h"
#include "core/identify/TrialShip.h"

namespace sagara::tools {
namespace {

struct DecayCase {
    VesselChoice ship;
    double roll_deg = 0.0;
    double speed_mps = 0.0;
    std::string file;
    double within_deg = 0.0;
};

DecayCase readCase(core::config::Reader& in) {
    DecayCase c;
    c.ship.vessel = in.text("vessel");
    c.ship.model = in.textOr("model", "");
    c.roll_deg = in.number("roll_deg", {-60.0, 60.0, "deg"});
    c.speed_mps = in.numberOr("speed_mps", 0.0, {0.0, 60.0, "m/s"});
    c.file = in.text("file");
    c.within_deg = in.number("within_deg", {1e-4, 60.0, "deg"});
    in.rejectUnknownKeys();
    return c;
}

/// The run with rows at the times of the published one, which are even.
core::Trial runOf(const core::Vessel& vessel, const DecayCase& c, const ReferenceTable& published) {
    core::TrialShip ship(vessel, c.ship.model);
    core::TrialOptions options;
    options.approach = ship.holding(c.speed_mps);
    options.duration_s = published.at("t", published.rows() - 1);
    options.sample_s = published.at("t", 1) - published.at("t", 0);
    options.step_s = *options.sample_s / std::ceil(*options.sample_s / options.step_s - 1e-9);
    return core::runDecay(ship, {.dof = core::Decay::Dof::Roll, .start = c.roll_deg * core::kDegree_rad},
                          options);
}

}  // namespace

ValidationOutcome runDecayCase(const ValidationContext& context, core::config::Reader& in) {
    const DecayCase c = readCase(in);
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto vessel = openVessel(context.documents, c.ship);
    if (!vessel) return outcome.trouble = vessel.error(), outcome;
    const auto published = ReferenceTable::read(context.reference(c.file));
    if (!published) return outcome.trouble = published.error(), outcome;
    const core::Trial trial = runOf(*vessel, c, *published);
    report::XyPlot plot;
    plot.xTitle = "time, s";
    plot.yTitle = "roll, deg";
    report::XyPlot::Series ours{"Sagara", false, {}}, theirs{"published", true, {}};
    double worst_deg = 0.0;
    for (std::size_t i = 0; i < std::min(trial.samples.size(), published->rows()); ++i) {
        const core::TrialSample& s = trial.samples[i];
        const double roll_deg = s.roll_rad / core::kDegree_rad;
        ours.at.emplace_back(s.time_s, roll_deg);
        theirs.at.emplace_back(published->at("t", i), published->at("phi", i));
        worst_deg = std::max(worst_deg, std::abs(roll_deg - published->at("phi", i)));
    }
    plot.series = {std::move(ours), std::move(theirs)};
    outcome.plots.push_back(std::move(plot));
    outcome.rows.push_back(
        {.quantity = "roll, largest error, deg", .measured = worst_deg, .tolerance = c.within_deg});
    return outcome;
}

}  // namespace sagara::tools
