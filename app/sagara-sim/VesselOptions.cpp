#include "VesselOptions.h"

#include "Between.h"

namespace sagara::sim {

CLI::Option* addVesselOptions(CLI::App& command, tools::VesselChoice& choice) {
    CLI::Option* vessel = command.add_option("--vessel", choice.vessel, "id in the database, or a file");
    command.add_option("--model", choice.model, "of the models in her document (the first)");
    command.add_option("--depth-m", choice.depth_m, "of the water (deep)")->check(between(0.1, 12'000.0));
    return vessel;
}

void addHullOptions(CLI::App& command, tools::HullChoice& choice) {
    CLI::Option* vessel = addVesselOptions(command, choice.ship);
    CLI::Option* file = command.add_option("--hull", choice.file, "file of stations, in place of a vessel");
    CLI::Option_group* which = command.add_option_group("hull");
    which->add_options(vessel, file);
    which->require_option(1);
}

void addCsvOption(CLI::App& command, std::string& csv) {
    command.add_option("--csv", csv, "file to write, or - for standard output (-)");
}

}  // namespace sagara::sim
