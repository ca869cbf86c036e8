#include "app/tools/Table.h"

#include <fmt/format.h>

#include "app/files/Files.h"
#include "app/run/Console.h"
#include "app/run/RunOptions.h"

namespace sagara::tools {

Table::Table(const std::vector<std::string>& columns) {
    for (const std::string& column : columns) m_text += (m_text.empty() ? "" : ",") + column;
    m_text += '\n';
}

void Table::add(const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i)
        m_text += fmt::format("{}{:.9g}", i == 0 ? "" : ",", values[i]);
    m_text += '\n';
}

void Table::add(const std::string& name, double value) { m_text += fmt::format("{},{:.9g}\n", name, value); }

int writeResult(const std::string& fileOrDash, const std::string& text) {
    if (fileOrDash == "-") {
        run::print(text);
        return run::kDone;
    }
    if (const auto trouble = files::writeTextFile(fileOrDash, text)) {
        run::tell(trouble->message);
        return run::kMachineFailed;
    }
    return run::kDone;
}

}  // namespace sagara::tools
