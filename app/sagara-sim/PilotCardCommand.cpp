#include "Commands.h"
#include "VesselOptions.h"
#include "app/tools/PilotCardTool.h"

namespace sagara::sim {

void addPilotCard(Commands& commands) {
    auto o = std::make_shared<tools::PilotCardOptions>();
    CLI::App* card = commands.add("pilot-card", "write the pilot card and wheelhouse poster of a vessel",
                                  [o](run::Store& store) { return tools::runPilotCard(store, *o); });
    addVesselOptions(*card, o->ship)->required();
    card->add_option("--pdf", o->pdf, "file to write")->required();
}

}  // namespace sagara::sim
