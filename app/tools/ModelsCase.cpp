#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/tools/CaseRows.h"
#include "app/tools/ModelsFigures.h"
#include "app/tools/VesselChoice.h"
#include "core/base/Units.h"
#include "core/seakeeping/Response.h"
#include "core/seakeeping/SeaHulls.h"

namespace sagara::tools {
namespace {

using core::config::Reader;
using Part = report::ValidationSection::Part;

constexpr std::size_t kLookOfStripTheory = 7;

/// A model of the comparison, which may be of another vessel where this one has none of its kind.
struct ComparedModel {
    std::string name, of, vessel, model;
    bool ridesLongWaves = false;  ///< claimed, and a row of the case
};

struct ModelsCase {
    std::string vessel;
    ModelTask task;
    std::vector<ComparedModel> models;
    TrialMarks marks;
    double shortest_L = 0.5, longest_L = 20.0;  ///< wavelengths
    int waves = 40;
    double longWaveWithin = 0.05;
    std::vector<std::string> remarks;  ///< of this vessel
};

ModelsCase readCase(Reader& in) {
    ModelsCase c;
    c.vessel = in.text("vessel");
    c.task.speed_mps = in.number("speed_mps", {0.1, 60.0, "m/s"});
    c.task.rudder_deg = in.number("rudder_deg", {1.0, 70.0, "deg"});
    c.task.zigzag_deg = in.number("zigzag_deg", {1.0, 40.0, "deg"});
    c.task.waveAmplitude_m = in.number("waveAmplitude_m", {0.01, 10.0, "m"});
    c.waves = in.integerOr("waves", c.waves, 2, 100);
    for (const auto& node : in.list("models")) {
        Reader model(node);
        c.models.push_back({model.text("name"), model.text("of"), model.textOr("vessel", c.vessel),
                            model.text("model"), model.flagOr("ridesLongWaves", false)});
        model.rejectUnknownKeys();
    }
    c.marks.from = in.text("against");
    for (const auto& node : in.list("marks")) {
        Reader mark(node);
        c.marks.marks.push_back({mark.text("name"), mark.number("value", {-1e6, 1e6, ""})});
        mark.rejectUnknownKeys();
    }
    c.remarks = in.texts("remarks");
    if (c.models.empty()) in.problem("models", "is empty", "one model or more");
    in.rejectUnknownKeys();
    return c;
}

/// Even steps of log wavelength, longest first.
std::vector<double> frequencies_radps(const ModelsCase& c, double length_m) {
    std::vector<double> omegas;
    for (int i = 0; i < c.waves; ++i) {
        const double lambdaOverL =
            c.longest_L * std::pow(c.shortest_L / c.longest_L, i / static_cast<double>(c.waves - 1));
        omegas.push_back(std::sqrt(core::kTwoPi * core::kGravity_mps2 / (lambdaOverL * length_m)));
    }
    return omegas;
}

/// The vessel's hull at rest by strip theory.
report::XyPlot::Series stripLine(const core::Vessel& vessel, const ModelTask& task, double heading_rad,
                                 std::size_t motion) {
    const core::HullResponse hull(core::hullFormOf(vessel.hull));
    report::XyPlot::Series line{"strip theory", false, {}, kLookOfStripTheory};
    for (const double omega_radps : task.omegas_radps) {
        const core::MetWave wave{omega_radps, heading_rad, 0.0};
        const double size = std::abs(hull.respond(wave, 2.0 * task.waveAmplitude_m).atGravity[motion]);
        line.at.emplace_back(omega_radps, motion < 3 ? size : size / wave.waveNumber_radpm());
    }
    return line;
}

Part tablesPart(const ModelsCase& c, const std::string& ship, const std::vector<ModelTrials>& models) {
    Part part;
    part.title = ship + ": models side by side";
    part.paragraphs = {
        "Her models side by side in the tables of Sandaruwan, Kodikara, Keppitiyagama and Rosa (2010). The "
        "wording "
        "of "
        "the printed tables was not at hand: their rows and columns are ours, by our reading of their "
        "subjects (I: degrees of freedom, II: features of ship models, IV: results). No number of the paper "
        "is repeated; every number is measured in this run, in calm or in regular waves, and each yes or no "
        "follows from the number below it by the rule under the table."};
    for (const std::string& remark : c.remarks) part.paragraphs.push_back(remark);
    part.tables = {tableOfFreedoms(models), tableOfFeatures(models)};
    return part;
}

Part figuresPart(const ModelsCase& c, const core::Vessel& vessel, const std::vector<ModelTrials>& models) {
    Part part;
    part.title = "Results: table IV, figures 11 to 13";
    const auto titled = [](report::XyPlot plot, std::string title) {
        plot.title = std::move(title);
        return plot;
    };
    part.paragraphs = {
        fmt::format("{}: figures 11 to 13 redone by our reading of them (turns to both sides with {:g} deg "
                    "of rudder and a "
                    "zigzag {:g}/{:g}, from {:.1f} kn), with the speed in the turn beside them. Lines that "
                    "lie on each other "
                    "are drawn once, under all their names.",
                    vessel.name, c.task.rudder_deg, c.task.zigzag_deg, c.task.zigzag_deg,
                    c.task.speed_mps / core::kKnot_mps)};
    part.tables = {tableOfResults(models, c.marks)};
    part.plots = {
        titled(turnFigure(models, &ModelTrials::turn, c.marks), "Figure 11 redone: turn to starboard"),
        titled(turnFigure(models, &ModelTrials::turnPort, c.marks), "Figure 12 redone: turn to port"),
        titled(zigzagFigure(models),
               fmt::format("Figure 13 redone: zigzag {:g}/{:g}", c.task.zigzag_deg, c.task.zigzag_deg)),
        titled(speedFigure(models), "Speed in the turn to starboard")};
    return part;
}

Part wavesPart(const ModelsCase& c, const core::Vessel& vessel, const std::vector<ModelTrials>& models) {
    Part part;
    part.title = "Response in waves: figures 17 to 19";
    const double height_m = 2.0 * c.task.waveAmplitude_m;
    const double shortest_m = c.shortest_L * vessel.hull.lengthBp_m;
    part.paragraphs = {
        fmt::format(
            "{}: figures 17 to 19 redone at rest with a possible wavelength. The paper measured them with "
            "a wave amplitude of 0.5 m and a wavelength of 0.5 m: a height of twice the length, where waves "
            "break at 0.142, and one wavelength for all frequencies. Here the amplitude is {:g} m and every "
            "frequency has the wavelength it has in deep water, 2 π g / ω²: from {:.0f} m to {:.0f} m, at "
            "most 1/{:.0f} steep.",
            vessel.name, c.task.waveAmplitude_m, shortest_m, c.longest_L * vessel.hull.lengthBp_m,
            shortest_m / height_m),
        "First harmonic of each model run in time, held at her place and heading; heave and pitch in head "
        "waves, "
        "roll in beam waves. The same hull by strip theory (sagara-sim rao) is the yardstick: no measured "
        "points "
        "of this hull are at hand. In a long wave a ship rides like a cork and every line must go to 1. What "
        "leaves the frame is cut off; tables I and II have its numbers."};
    const auto titled = [](report::XyPlot plot, std::string title) {
        plot.title = std::move(title);
        return plot;
    };
    const auto strip = [&](double heading_rad, std::size_t motion) {
        return stripLine(vessel, c.task, heading_rad, motion);
    };
    part.plots = {titled(responseFigure(models, &WaveAnswer::heave, false, strip(core::kPi, 2)),
                         "Figure 17 redone: heave in head waves"),
                  titled(responseFigure(models, &WaveAnswer::pitch_k, false, strip(core::kPi, 4)),
                         "Figure 18 redone: pitch in head waves"),
                  titled(responseFigure(models, &WaveAnswer::roll_k, true, strip(0.5 * core::kPi, 3)),
                         "Figure 19 redone: roll in beam waves")};
    return part;
}

}  // namespace

/// The models of the founding paper's comparison side by side.
ValidationOutcome runModelsCase(const ValidationContext& context, Reader& in) {
    ModelsCase c = readCase(in);
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto ship = openVessel(context.documents, VesselChoice{c.vessel, {}});
    if (!ship) return outcome.trouble = ship.error(), outcome;
    const auto hulls =
        context.documents.hulls() ? context.documents.hulls() : std::make_shared<core::SeaHulls>();
    std::vector<ModelTrials> models;
    for (const ComparedModel& m : c.models) {
        const auto vessel = openVessel(context.documents, VesselChoice{m.vessel, m.model});
        if (!vessel) return outcome.trouble = vessel.error(), outcome;
        c.task.omegas_radps = frequencies_radps(c, vessel->hull.lengthBp_m);
        models.push_back(runModelTrials(m.name, *vessel, m.model, c.task, hulls->of(vessel->hull)));
        models.back().of = m.of;
        if (m.ridesLongWaves)
            outcome.rows.push_back({.quantity = m.name + ": heave in a long wave",
                                    .measured = models.back().waves.front().head.heave,
                                    .reference = 1.0,
                                    .tolerance = c.longWaveWithin,
                                    .share = true});
    }
    c.task.omegas_radps = frequencies_radps(c, ship->hull.lengthBp_m);
    outcome.sections = {
        {"Founding paper",
         {tablesPart(c, ship->name, models), figuresPart(c, *ship, models), wavesPart(c, *ship, models)}}};
    return outcome;
}

}  // namespace sagara::tools
