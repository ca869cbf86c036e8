#pragma once

#include <string>
#include <vector>

#include "ui/report/XyPlot.h"

namespace sagara::report {

/// A table of a section, the first column as wide as what the others leave.
struct SectionTable {
    struct Column {
        std::string title;
        double width_mm = 20.0;
    };
    struct Cell {
        std::string text;
        std::string note = {};  ///< second line, small
        bool quiet = false;     ///< told apart by a quieter colour: what is not there
    };
    std::string title;
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows;
    std::string note;  ///< below it
};

/// Pages of their own.
struct ValidationSection {
    struct Part {
        std::string title;
        std::vector<std::string> paragraphs;
        std::vector<SectionTable> tables;
        std::vector<XyPlot> plots;
    };
    std::string title;  ///< in the header of its pages
    std::vector<Part> parts;
};

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
    std::vector<ValidationSection> sections;
    std::vector<Source> sources;
};

/// Writes it as PDF, A4: table, plots, sections, sources. Throws std::runtime_error when the file cannot be
/// written. Needs a QGuiApplication.
void writeValidationReport(const ValidationData& data, const std::string& path);

}  // namespace sagara::report
