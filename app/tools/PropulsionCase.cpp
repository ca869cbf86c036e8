#include "app/tools/CaseRows.h"
#include "app/tools/ReferenceTable.h"
#include "app/tools/VesselChoice.h"
#include "core/vessel/WageningenB.h"

namespace sagara::tools {
namespace {

struct PropulsionCase {
    std::string vessel;  ///< empty: the B-series alone
    std::string file;
    double share = 0.0;
};

/// KT of the vessel's propeller over J.
void addThrust(ValidationOutcome& outcome, const PropulsionCase& c, const core::Vessel& vessel,
               const ReferenceTable& table) {
    const auto& k = vessel.propulsion.units.front().thrustCoefficients;
    const auto thrustAt = [&](double J) { return k[0] + J * (k[1] + J * k[2]); };
    RelativeErrors errors;
    report::XyPlot plot;
    plot.xTitle = "advance ratio J";
    plot.yTitle = "thrust coefficient KT";
    plot.series = {{"Sagara", false, {}}, {"published", true, {}}};
    for (int i = 0; i <= 50; ++i) plot.series[0].at.emplace_back(0.02 * i, thrustAt(0.02 * i));
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double J = table.at("J", row), published = table.at("KT_report", row);
        errors.add(thrustAt(J), published);
        plot.series[1].at.emplace_back(J, published);
    }
    outcome.rows.push_back(largestErrorRow("KT", errors, c.share));
    outcome.plots.push_back(std::move(plot));
}

/// KT and KQ of screws of the B-series.
void addSeries(ValidationOutcome& outcome, const PropulsionCase& c, const ReferenceTable& table) {
    const auto screwOf = [&](std::size_t row) {
        return core::BScrew{static_cast<int>(table.at("Z", row)), table.at("AEA0", row), table.at("PD", row)};
    };
    RelativeErrors thrust, torque;
    const core::BScrew first = screwOf(0);
    report::XyPlot plot;
    plot.note = "B" + table.text("Z", 0) + "-" + table.text("AEA0", 0) + ", P/D " + table.text("PD", 0);
    plot.xTitle = "advance ratio J";
    plot.yTitle = "KT, 10 KQ";
    plot.series = {{"KT", false, {}}, {"10 KQ", false, {}}, {"published", true, {}}};
    for (int i = 0; i <= 40; ++i) {
        const double J = 0.02 * i;
        plot.series[0].at.emplace_back(J, first.thrustCoefficient(J));
        plot.series[1].at.emplace_back(J, 10.0 * first.torqueCoefficient(J));
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const core::BScrew screw = screwOf(row);
        const double J = table.at("J", row), KT = table.at("KT", row), KQ = table.at("KQ", row);
        thrust.add(screw.thrustCoefficient(J), KT);
        torque.add(screw.torqueCoefficient(J), KQ);
        if (screw.blades != first.blades || screw.areaRatio != first.areaRatio ||
            screw.pitchRatio != first.pitchRatio)
            continue;
        plot.series[2].at.emplace_back(J, KT);
        plot.series[2].at.emplace_back(J, 10.0 * KQ);
    }
    outcome.rows.push_back(largestErrorRow("KT", thrust, c.share));
    outcome.rows.push_back(largestErrorRow("KQ", torque, c.share));
    outcome.plots.push_back(std::move(plot));
}

}  // namespace

ValidationOutcome runPropulsionCase(const ValidationContext& context, core::config::Reader& in) {
    const PropulsionCase c{in.textOr("vessel", ""), in.text("file"), readShare(in, "share")};
    in.rejectUnknownKeys();
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto table = ReferenceTable::read(context.reference(c.file));
    if (!table) return outcome.trouble = table.error(), outcome;
    if (c.vessel.empty()) return addSeries(outcome, c, *table), outcome;
    const auto vessel = openVessel(context.documents, VesselChoice{c.vessel, {}});
    if (!vessel) return outcome.trouble = vessel.error(), outcome;
    if (vessel->propulsion.units.empty()) return outcome.trouble = c.vessel + ": has no propeller", outcome;
    addThrust(outcome, c, *vessel, *table);
    return outcome;
}

}  // namespace sagara::tools
