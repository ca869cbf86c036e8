#pragma once

#include <map>
#include <string>
#include <vector>

namespace sagara::test {

/// One row of a reference table: text of every column by its name.
class Row {
public:
    explicit Row(std::map<std::string, std::string> cells) : m_cells(std::move(cells)) {}
    const std::string& text(const std::string& column) const { return m_cells.at(column); }
    bool has(const std::string& column) const { return !m_cells.at(column).empty(); }
    double operator[](const std::string& column) const { return std::stod(m_cells.at(column)); }

private:
    std::map<std::string, std::string> m_cells;
};

/// A CSV file of tests/reference: lines that begin with # are its header and are skipped.
std::vector<Row> readReference(const std::string& pathUnderReference);
/// Any file of tests/reference as it is.
std::string readReferenceText(const std::string& pathUnderReference);
/// Any CSV file in the same form.
std::vector<Row> readCsv(const std::string& path);

}  // namespace sagara::test
