#include "Between.h"
#include "Commands.h"
#include "VesselOptions.h"
#include "app/tools/RaoTool.h"

namespace sagara::sim {

void addRao(Commands& commands) {
    auto o = std::make_shared<tools::RaoOptions>();
    CLI::App* rao = commands.add("rao", "motions of a hull in regular waves, by strip theory",
                                 [o](run::Store& store) { return tools::runRao(store, *o); });
    addHullOptions(*rao, o->hull);
    rao->add_option("--wave-height-m", o->waveHeight_m, "crest to trough, for the damping of roll (Lpp / 50)")
        ->check(between(1e-6, 40.0));
    rao->add_option("--speed-mps", o->speed_mps, "ahead (0)")->check(between(0.0, 60.0));
    rao->add_option("--heading-deg", o->heading_deg,
                    "180 head sea, 90 waves from starboard, 0 following (180)")
        ->check(between(-360.0, 360.0));
    CLI::Option_group* waves = rao->add_option_group("waves");
    waves->add_option("--omega", o->omegas_radps, "frequencies of the waves, rad/s: w1,w2,...")
        ->delimiter(',')
        ->check(between(1e-3, 100.0));
    waves->add_option("--lambda-over-L", o->lambdasOverLpp, "wavelengths over Lpp: l1,l2,...")
        ->delimiter(',')
        ->check(between(0.02, 1e4));
    waves->require_option(1);
    rao->add_flag("--time-domain", o->timeDomain, "measured by running the hull through each wave");
    addCsvOption(*rao, o->csv);
}

}  // namespace sagara::sim
