#include "app/tools/TrialResult.h"

#include <cmath>

#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "app/tools/Table.h"

namespace sagara::tools {

void takeRows(core::TrialOptions& options, std::optional<double> dt_s) {
    if (!dt_s) return;
    options.sample_s = dt_s;
    options.step_s = *dt_s / std::ceil(*dt_s / options.step_s - 1e-9);
}

int writeTrial(const core::Vessel& vessel, const core::Trial& trial, const std::string& series, bool measures,
               const std::string& csv) {
    const std::string who = vessel.id + ": " + trial.title + ": ";
    if (trial.end == core::TrialEnd::NotFinite)
        return run::tell(who + "the model left the numbers"), run::kMachineFailed;
    if (trial.end == core::TrialEnd::TimedOut)
        run::tell(who + "did not get there; what was reached is written");
    if (!measures) return writeResult(csv, series);
    const int code = csv == "-" ? run::kDone : writeResult(csv, series);
    Table table({"name", "value"});
    for (const core::TrialMeasure& m : trial.measures) table.add(m.name, m.value);
    run::print(table.text());
    return code;
}

}  // namespace sagara::tools
