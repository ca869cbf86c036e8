#include "app/tools/IdentifyTool.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/files/Files.h"
#include "app/files/FindDocument.h"
#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "app/tools/IdentifyReport.h"
#include "app/tools/Table.h"
#include "app/tools/Trials.h"
#include "core/identify/FittedDocument.h"
#include "core/vessel/CompleteVessel.h"

namespace sagara::tools {
namespace {

/// What is wrong with the groups asked for; empty: nothing.
std::string unknownGroups(const core::NamedModel& model, const std::vector<std::string>& wanted) {
    const std::set<std::string> known = core::coefficientGroupsOf(model);
    std::string names, unknown;
    for (const std::string& k : known) names += (names.empty() ? "" : ", ") + k;
    for (const std::string& w : wanted)
        if (known.count(w) == 0) unknown += (unknown.empty() ? "" : ", ") + w;
    return unknown.empty() ? unknown
                           : "--fit: model " + model.name + " has no " + unknown + ", expected " + names;
}

/// Trials in water that she does not float in; empty: none.
std::string aground(const core::Vessel& vessel, const std::vector<core::SeaTrial>& trials) {
    std::string text;
    for (const core::SeaTrial& t : trials) {
        if (t.depth_m > vessel.hull.draught_m) continue;
        if (!text.empty()) text += '\n';
        text += fmt::format("{}: depth_m is {:g}, expected more than her draught, {:g} m", t.name, t.depth_m,
                            vessel.hull.draught_m);
    }
    return text;
}

std::vector<core::SwingFit> swingsOf(const core::Vessel& vessel, const std::vector<core::SeaTrial>& trials) {
    std::vector<core::SwingFit> swings;
    for (const core::Channel motion : {core::Channel::Roll, core::Channel::Pitch, core::Channel::Heave})
        if (auto fit = core::fitSwing(vessel, trials, motion)) swings.push_back(std::move(*fit));
    return swings;
}

/// Trials that neither the manoeuvres nor the swings could use.
std::vector<std::string> unusedOf(const Identified& found, const std::vector<core::SeaTrial>& trials) {
    std::vector<std::string> unused;
    for (const core::SeaTrial& trial : trials) {
        const auto& used = found.manoeuvres.trials;
        bool told =
            std::any_of(used.begin(), used.end(), [&](const auto& t) { return t.name == trial.name; });
        for (const core::SwingFit& s : found.swings)
            told = told || std::count(s.trials.begin(), s.trials.end(), trial.name) > 0;
        if (!told) unused.push_back(trial.name);
    }
    return unused;
}

}  // namespace

int runIdentify(const run::Store& store, const IdentifyOptions& o) {
    const auto vessel = openVessel(store, o.ship);
    const auto trials = readTrials(o.trials);
    if (!vessel) run::tell(vessel.error());
    if (!trials) run::tell(trials.error());
    if (!vessel || !trials) return run::kBadRequest;
    const core::NamedModel& model = *vessel->model(o.ship.model).value();
    if (const std::string wrong = unknownGroups(model, o.fit); !wrong.empty())
        return run::tell(wrong), run::kBadRequest;
    if (const std::string wrong = aground(*vessel, *trials); !wrong.empty())
        return run::tell(wrong), run::kBadRequest;

    run::Progress progress;
    core::ManoeuvreFitOptions options{o.ship.model, {o.fit.begin(), o.fit.end()}, {}};
    options.watch = [&](int iteration) {
        if (progress.due()) progress.show("iteration " + std::to_string(iteration));
        return true;
    };
    Identified found{vessel->id,
                     model.name,
                     core::fitManoeuvres(*vessel, *trials, options),
                     core::fitNomoto(*trials, vessel->hull.lengthBp_m),
                     swingsOf(*vessel, *trials),
                     {}};
    if (!found.manoeuvres.found)
        return run::tell(vessel->id + ": the model leaves the numbers in these trials"), run::kMachineFailed;
    found.unused = unusedOf(found, *trials);

    const auto document = files::findDocument(store, core::DocumentKind::Vessel, o.ship.vessel);
    const std::string fitted = core::fittedDocument(*core::completeVessel(document->name, document->text),
                                                    o.ship.model, found.manoeuvres, found.swings);
    if (const auto trouble = files::writeTextFile(o.out, fitted))
        return run::tell(trouble->message), run::kMachineFailed;
    run::print(identifyReport(found));
    return o.report.empty() ? run::kDone : writeResult(o.report, coefficientsCsv(found));
}

}  // namespace sagara::tools
