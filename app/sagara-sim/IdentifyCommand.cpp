#include "Commands.h"
#include "VesselOptions.h"
#include "app/tools/IdentifyTool.h"

namespace sagara::sim {

void addIdentify(Commands& commands) {
    auto o = std::make_shared<tools::IdentifyOptions>();
    CLI::App* identify = commands.add(
        "identify", "fit a vessel's model to her trials; app/tools/README.md says what a trial is",
        [o](run::Store& store) { return tools::runIdentify(store, *o); });
    identify->add_option("--vessel", o->ship.vessel, "id or file")->required();
    identify->add_option("--model", o->ship.model, "one of her models (her first)");
    identify->add_option("--trials", o->trials, "folder of trials, one CSV each")->required();
    identify->add_option("--out", o->out, "the fitted vessel document")->required();
    identify
        ->add_option(
            "--fit", o->fit,
            "groups, by commas: hull, wake, rudder of mmg; turning, resistance, roll of others (all)")
        ->delimiter(',');
    identify->add_option("--report", o->report, "coefficients as CSV, - for standard output");
}

}  // namespace sagara::sim
