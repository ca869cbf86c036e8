#include "Commands.h"
#include "VesselOptions.h"
#include "app/tools/HydrostaticsTool.h"

namespace sagara::sim {

void addHydrostatics(Commands& commands) {
    auto o = std::make_shared<tools::HydrostaticsOptions>();
    CLI::App* hydrostatics =
        commands.add("hydrostatics", "displacement, centres, stability and righting levers of a hull",
                     [o](run::Store& store) { return tools::runHydrostatics(store, *o); });
    addHullOptions(*hydrostatics, o->hull);
    addCsvOption(*hydrostatics, o->csv);
}

}  // namespace sagara::sim
