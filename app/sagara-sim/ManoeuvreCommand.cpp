#include "Between.h"
#include "Commands.h"
#include "VesselOptions.h"
#include "app/tools/Manoeuvre.h"

namespace sagara::sim {

void addManoeuvre(Commands& commands) {
    using tools::ManoeuvreOptions;
    using Test = ManoeuvreOptions::Test;
    auto o = std::make_shared<ManoeuvreOptions>();
    CLI::App* manoeuvre = commands.add("manoeuvre", "run a standard manoeuvre of a vessel in calm water",
                                       [o](run::Store& store) { return tools::runManoeuvre(store, *o); });
    addVesselOptions(*manoeuvre, o->ship)->required();
    manoeuvre->add_option("--test", o->test, "turning, zigzag, spiral, reverse-spiral, stopping or pullout")
        ->required()
        ->transform(
            CLI::CheckedTransformer(std::map<std::string, Test>{{"turning", Test::Turning},
                                                                {"zigzag", Test::Zigzag},
                                                                {"spiral", Test::Spiral},
                                                                {"reverse-spiral", Test::ReverseSpiral},
                                                                {"stopping", Test::Stopping},
                                                                {"pullout", Test::Pullout}}));
    manoeuvre->add_option("--rudder-deg", o->rudder_deg, "positive to starboard (usual for the test)")
        ->check(between(-90.0, 90.0));
    manoeuvre->add_option("--heading-deg", o->heading_deg, "at which a zigzag switches (as the rudder)")
        ->check(between(0.1, 180.0));
    manoeuvre
        ->add_option("--first", o->starboardFirst,
                     "side a zigzag begins to: starboard or port (that of the rudder)")
        ->transform(
            CLI::CheckedTransformer(std::map<std::string, bool>{{"starboard", true}, {"port", false}}));
    manoeuvre->add_option("--speed-mps", o->speed_mps, "before it (full ahead)")->check(between(0.05, 60.0));
    manoeuvre->add_option("--shaft-rps", o->shaft_rps, "of the shafts (what holds that speed)")
        ->check(between(-100.0, 100.0));
    manoeuvre->add_option("--duration-s", o->duration_s, "of the run (as long as the measures need)")
        ->check(between(0.1, kLongest_s));
    manoeuvre->add_option("--dt-s", o->dt_s, "between rows, and the longest step of the integration")
        ->check(between(1e-4, 60.0));
    manoeuvre->add_flag("--measures", o->measures, "print name,value rows of what is measured");
    addCsvOption(*manoeuvre, o->csv);
}

}  // namespace sagara::sim
