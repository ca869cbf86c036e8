#pragma once

#include <string>
#include <vector>

namespace sagara::core::config {

/// One thing wrong in a document: where, what was found, what would be accepted.
struct Problem {
    std::string path;   ///< JSON path such as "propulsion[0].diameter_m"; empty for the document as a whole
    std::string found;  ///< "is -107.3", "is missing", "is unknown"
    std::string expected;  ///< "1 to 1000 s"
};

/// Every problem of one document, in the order found.
class Problems {
public:
    explicit Problems(std::string document = {}) : m_document(std::move(document)) {}

    void add(Problem problem) { m_list.push_back(std::move(problem)); }
    /// Those of another document, under its own name.
    void append(const Problems& other);

    bool empty() const { return m_list.empty() && m_appended.empty(); }
    std::size_t size() const { return m_list.size() + m_appended.size(); }
    const std::vector<Problem>& list() const { return m_list; }
    /// "mariner.json: nomoto.timeConstant_s is -107.3, expected 1 to 1000 s", one line each.
    std::vector<std::string> messages() const;
    /// The messages joined by newlines.
    std::string text() const;

private:
    std::string m_document;
    std::vector<Problem> m_list;
    std::vector<std::string> m_appended;
};

}  // namespace sagara::core::config
