#include "app/tools/PilotCardTool.h"

#include <fmt/format.h>

#include <stdexcept>

#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "core/vessel/Ballast.h"
#include "ui/pilotcard/PilotCardOf.h"

namespace sagara::tools {
namespace {

constexpr double kShallow = 1.2;  // depth over draught: where the bottom is felt most and ships still go

double shallowDepth_m(const core::Vessel& vessel, const PilotCardOptions& o) {
    return o.ship.depth_m < core::kDeepWater_m ? o.ship.depth_m : kShallow * vessel.hull.draught_m;
}

core::StandardTrials trialsOf(const core::Vessel& vessel, const ui::TriedIn& in) {
    run::Progress progress;
    const auto watch = [&](double share, const std::string& title) {
        if (progress.due()) progress.show(fmt::format("{}: {}, {:.0f} %", in.title, title, 100.0 * share));
        return true;
    };
    return core::runStandardTrials(vessel, watch, in.model, in.depth_m);
}

void addCondition(report::PilotCardData& card, const core::Vessel& vessel, const ui::TriedIn& in,
                  const std::string& note) {
    card.conditions.push_back(ui::conditionOf(vessel, trialsOf(vessel, in), in));
    card.conditions.back().note = note;
}

report::PilotCardData cardOf(const core::Vessel& loaded, const PilotCardOptions& o) {
    const double shallow_m = shallowDepth_m(loaded, o);
    const std::string depth = fmt::format("{:.1f} m", shallow_m);
    const ui::TriedIn deep{.model = o.ship.model};
    const std::string date = core::formatUtc(run::now()).substr(0, 10);
    report::PilotCardData card = ui::pilotCardOf(loaded, trialsOf(loaded, deep), date, deep);
    addCondition(card, loaded, {"Loaded, shallow water, " + depth, o.ship.model, shallow_m},
                 fmt::format("Depth over draught {:.2f}.", shallow_m / loaded.hull.draught_m));
    const auto ballast = core::inBallast(loaded);
    if (!ballast) {
        card.conditions.back().note += " No ballast: her published set holds for this loading alone.";
        return card;
    }
    const std::string note = fmt::format("Draught {:.2f} m, {:.0f} t, estimated from the loaded ship.",
                                         ballast->hull.draught_m, ballast->hull.mass_kg() / 1000.0);
    addCondition(card, *ballast, {.title = "Ballast, deep water"}, note);
    addCondition(card, *ballast,
                 {.title = "Ballast, shallow water, " + depth, .model = {}, .depth_m = shallow_m}, note);
    return card;
}

}  // namespace

int runPilotCard(const run::Store& store, const PilotCardOptions& o) {
    const auto vessel = openVessel(store, o.ship);
    if (!vessel) return run::tell(vessel.error()), run::kBadRequest;
    try {
        report::writePilotCard(cardOf(*vessel, o), o.pdf.string());
    } catch (const std::runtime_error& e) {
        return run::tell(e.what()), run::kMachineFailed;
    }
    return run::kDone;
}

}  // namespace sagara::tools
