#include "app/tools/ReferenceTable.h"

#include <charconv>
#include <limits>
#include <sstream>

#include "app/files/Files.h"

namespace sagara::tools {
namespace {

std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    return cells;
}

double numberIn(const std::string& cell) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    const bool good = error == std::errc() && end == cell.data() + cell.size();
    return good ? value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

core::Result<ReferenceTable, std::string> ReferenceTable::read(const std::filesystem::path& file) {
    const auto text = files::readTextFile(file);
    if (!text) return text.error().message;
    ReferenceTable table;
    std::vector<std::string> names;
    std::istringstream in(*text);
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::vector<std::string> cells = cellsOf(line);
        if (names.empty()) {
            names = cells;
            for (const std::string& name : names) table.m_columns[name];
            continue;
        }
        for (std::size_t i = 0; i < names.size(); ++i) {
            const std::string cell = i < cells.size() ? cells[i] : std::string();
            table.m_columns[names[i]].push_back({cell, numberIn(cell)});
        }
        ++table.m_rows;
    }
    if (table.m_rows == 0) return file.string() + ": has no rows";
    return table;
}

}  // namespace sagara::tools
