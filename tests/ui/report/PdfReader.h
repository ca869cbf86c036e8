#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/report/ReportData.h"

namespace sagara::report::test {

/// Where the tests put their PDFs: $SAGARA_REPORT_OUT when it is set, to look at them afterwards; else a
/// folder of this process that is removed at its end.
std::filesystem::path outFolder();

/// Writes a report and gives its path.
std::filesystem::path written(const RunReport& report, const std::string& name);

/// Whether poppler's pdftotext is installed.
bool canReadPdf();
/// Text of every page as pdftotext -layout gives it.
std::vector<std::string> pagesOf(const std::filesystem::path& pdf);
/// Number of page objects, read from the file itself.
std::size_t countedPages(const std::filesystem::path& pdf);

}  // namespace sagara::report::test
