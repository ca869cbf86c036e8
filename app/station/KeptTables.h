#pragma once

#include <memory>

#include "ui/settings/SettingsStore.h"
#include "ui/theme/Page.h"

namespace sagara::station {

/// The widths a person gave to columns, and the sorting, of every table the page has now: as they were left
/// on an earlier page of its kind, kept in `settings` when the page goes. A table is known by the page's help
/// topic and its own name, or its place among those without.
void keepTables(ui::Page& page, std::unique_ptr<ui::SettingsStore> settings);

}  // namespace sagara::station
