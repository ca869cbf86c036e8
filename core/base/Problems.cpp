#include "core/base/Problems.h"

namespace sagara::core::config {

void Problems::append(const Problems& other) {
    for (std::string& message : other.messages()) m_appended.push_back(std::move(message));
}

std::vector<std::string> Problems::messages() const {
    std::vector<std::string> lines;
    for (const Problem& p : m_list) {
        std::string line = m_document + ": " + p.path + (p.path.empty() ? "" : " ") + p.found;
        if (!p.expected.empty()) line += ", expected " + p.expected;
        lines.push_back(std::move(line));
    }
    lines.insert(lines.end(), m_appended.begin(), m_appended.end());
    return lines;
}

std::string Problems::text() const {
    std::string all;
    for (const std::string& line : messages()) all += (all.empty() ? "" : "\n") + line;
    return all;
}

}  // namespace sagara::core::config
