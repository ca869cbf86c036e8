#pragma once

#include "app/run/Store.h"
#include "ui/help/AboutDialog.h"

namespace sagara::station {

/// Version, build and who must be named: assets/ATTRIBUTION.md, and the "attribution" of every area and
/// vessel of this installation.
ui::AboutFacts aboutFacts(run::Store& store);

/// The folder assets/help of this installation, for ui::showHelp.
std::filesystem::path helpFolder();

}  // namespace sagara::station
