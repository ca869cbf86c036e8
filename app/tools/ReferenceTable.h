#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/Result.h"

namespace sagara::tools {

/// A published table as CSV: lines that begin with # say what it is, then a line of names, then rows.
class ReferenceTable {
public:
    /// The error names the file.
    static core::Result<ReferenceTable, std::string> read(const std::filesystem::path& file);

    bool has(const std::string& column) const { return m_columns.count(column) > 0; }
    std::size_t rows() const { return m_rows; }
    /// NaN where the cell is no number.
    double at(const std::string& column, std::size_t row) const { return m_columns.at(column)[row].number; }
    const std::string& text(const std::string& column, std::size_t row) const {
        return m_columns.at(column)[row].text;
    }

private:
    struct Cell {
        std::string text;
        double number;
    };
    std::map<std::string, std::vector<Cell>> m_columns;
    std::size_t m_rows = 0;
};

}  // namespace sagara::tools
