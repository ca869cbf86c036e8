#include "tests/support/ReferenceCsv.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace sagara::test {
namespace {

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    if (!line.empty() && line.back() == ',') cells.emplace_back();
    return cells;
}

}  // namespace

std::vector<Row> readCsv(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot open " + path);
    std::vector<std::string> columns;
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (line.empty() || line[0] == '#') continue;
        const std::vector<std::string> cells = split(line);
        if (columns.empty()) {
            columns = cells;
            continue;
        }
        std::map<std::string, std::string> row;
        for (std::size_t i = 0; i < columns.size(); ++i) row[columns[i]] = i < cells.size() ? cells[i] : "";
        rows.emplace_back(std::move(row));
    }
    return rows;
}

std::vector<Row> readReference(const std::string& pathUnderReference) {
    return readCsv(std::string(SAGARA_TEST_DATA) + "/" + pathUnderReference);
}

std::string readReferenceText(const std::string& pathUnderReference) {
    const std::string path = std::string(SAGARA_TEST_DATA) + "/" + pathUnderReference;
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot open " + path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace sagara::test
