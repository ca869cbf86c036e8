#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ui/report/ReportData.h"

namespace sagara::core {
class SeaHulls;
}

namespace sagara::run {

/// Reads a recording and writes the report of its run, with what the assessor said of it. For any thread; it
/// touches no database but for its `hulls`. `goOn` is told how far it is, in percent, and gives false to
/// stop: nothing is written then. The text is the trouble, or empty.
std::string writeRecordingReport(const std::filesystem::path& recording,
                                 const std::optional<report::AssessorNote>& assessor,
                                 const std::filesystem::path& to, std::shared_ptr<core::SeaHulls> hulls,
                                 const std::function<bool(int)>& goOn);

}  // namespace sagara::run
