#pragma once

#include <CLI/CLI.hpp>

#include "app/tools/HullChoice.h"

namespace sagara::sim {

/// --vessel, --model and --depth-m, as all tools about the motion of a ship have them. Returns --vessel.
CLI::Option* addVesselOptions(CLI::App& command, tools::VesselChoice& choice);
/// --vessel or --hull, one of them, and the rest of `addVesselOptions`.
void addHullOptions(CLI::App& command, tools::HullChoice& choice);
/// --csv FILE or - for standard output.
void addCsvOption(CLI::App& command, std::string& csv);

}  // namespace sagara::sim
