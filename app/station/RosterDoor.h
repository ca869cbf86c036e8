#pragma once

#include <filesystem>

#include "app/run/RunSummary.h"
#include "app/station/Frame.h"
#include "db/RunRepository.h"

namespace sagara::station {

/// People, assigned missions and every run.
ui::Page* rosterPage(Frame& frame);

/// The result of a run that has just ended, with its assessment. A run that could not be filed is shown, too,
/// and says why it cannot be assessed yet.
ui::Page* resultPage(Frame& frame, const std::filesystem::path& recording, const run::RunSummary& summary);
/// The result of a run of the database.
ui::Page* resultPage(Frame& frame, db::RunId run);

}  // namespace sagara::station
