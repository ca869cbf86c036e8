#include "Between.h"
#include "Commands.h"
#include "VesselOptions.h"
#include "app/tools/DecayTool.h"

namespace sagara::sim {

void addDecay(Commands& commands) {
    using Dof = core::Decay::Dof;
    auto o = std::make_shared<tools::DecayOptions>();
    CLI::App* decay = commands.add("decay", "let a vessel go from a heel, trim or immersion in calm water",
                                   [o](run::Store& store) { return tools::runDecayTool(store, *o); });
    addVesselOptions(*decay, o->ship)->required();
    decay->add_option("--dof", o->dof, "roll, heave or pitch")
        ->required()
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, Dof>{{"roll", Dof::Roll}, {"heave", Dof::Heave}, {"pitch", Dof::Pitch}}));
    decay
        ->add_option("--start", o->start,
                     "deg, starboard side down or bow up positive; heave: m, down positive")
        ->required()
        ->check(between(-60.0, 60.0));
    decay->add_option("--speed-mps", o->speed_mps, "straight ahead (0)")->check(between(0.0, 60.0));
    decay->add_option("--duration-s", o->duration_s, "of the run (until the motion has died down)")
        ->check(between(0.1, kLongest_s));
    decay->add_option("--dt-s", o->dt_s, "between rows (0.1)")->check(between(1e-4, 60.0));
    decay->add_flag("--measures", o->measures, "print name,value rows: period, damping ratio, peaks");
    addCsvOption(*decay, o->csv);
}

}  // namespace sagara::sim
