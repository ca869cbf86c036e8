#pragma once

#include <string>
#include <vector>

namespace sagara::tools {

/// Rows under named columns, as CSV. Units stand in the names: "time_s". Numbers with nine figures.
class Table {
public:
    explicit Table(const std::vector<std::string>& columns);
    void add(const std::vector<double>& values);
    void add(const std::string& name, double value);  ///< a row of `name,value`
    const std::string& text() const { return m_text; }

private:
    std::string m_text;
};

/// Writes what a tool has to say to a file, or to standard output for "-". Returns the exit code.
int writeResult(const std::string& fileOrDash, const std::string& text);

}  // namespace sagara::tools
