#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/import/AreaImport.h"

/// sagara-import DESCRIPTION.json --out AREA.json
/// Exit codes: 0 the area was written, 1 the machine failed, 2 bad input, with every problem on standard
/// error. Only 0 leaves anything written.
namespace {

constexpr int kMachineFailed = 1;
constexpr int kBadInput = 2;

int run(const std::string& description, const std::string& out) {
    std::vector<std::string> report;
    const sagara::core::config::Problems problems =
        sagara::importer::importAreaFile(description, out, report);
    for (const std::string& line : report) std::printf("%s\n", line.c_str());
    if (!problems.empty()) std::fprintf(stderr, "%s\n", problems.text().c_str());
    return problems.empty() ? 0 : kBadInput;
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app("Makes an area document of Sagara from an import description and its source data.");
    std::string description, out;
    app.add_option("description", description,
                   "the import description, a JSON file; its sources lie beside it")
        ->required();
    app.add_option("--out", out, "the area document to write")->required();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : kBadInput;
    }
    return run(description, out);
} catch (const std::exception& e) {
    std::fprintf(stderr, "sagara-import: %s\n", e.what());
    return kMachineFailed;
}
