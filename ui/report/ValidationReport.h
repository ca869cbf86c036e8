#pragma once

#include <string>
#include <vector>

#include "ui/report/XyPlot.h"

namespace sagara::report {

/// Cases that were run against published numbers. Plain values in the units that are printed.
struct ValidationData {
    struct Row {
        std::string title;  ///< of the case
        std::string kind;   ///< verification, validation or trend
        std::string quantity;
        std::string measured;
        std::string reference;
        std::string error;
        std::string tolerance;
        bool ok = false;
    };
    struct Source {
        std::string title;
        std::string source;
        std::string note;  ///< where the case is claimed, and why not elsewhere
    };
    std::string date;
    std::string program;  ///< which build
    std::vector<Row> rows;
    std::vector<XyPlot> plots;
    std::vector<Source> sources;
};

/// Writes it as PDF, A4: table, plots, sources. Throws std::runtime_error when the file cannot be written.
/// Needs a QGuiApplication.
void writeValidationReport(const ValidationData& data, const std::string& path);

}  // namespace sagara::report
