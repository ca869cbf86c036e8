#pragma once

#include <string>

#include "app/station/Frame.h"

namespace sagara::station {

/// The scenario editor over the installation's documents. An empty id: the list of scenarios, and new ones.
ui::Page* editorPage(Frame& frame, const std::string& scenarioId = {});

}  // namespace sagara::station
