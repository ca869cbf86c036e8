#include "app/tools/Trials.h"

#include <algorithm>

#include "app/files/Files.h"

namespace sagara::tools {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> csvFilesIn(const fs::path& folder, std::error_code& trouble) {
    std::vector<fs::path> files;
    for (fs::directory_iterator i(folder, trouble), end; !trouble && i != end; i.increment(trouble))
        if (i->path().extension() == ".csv") files.push_back(i->path());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

core::Result<std::vector<core::SeaTrial>, std::string> readTrials(const fs::path& folder) {
    std::error_code trouble;
    const std::vector<fs::path> files = csvFilesIn(folder, trouble);
    if (trouble)
        return folder.string() + ": cannot be read (" + trouble.message() + "), expected a folder of trials";
    if (files.empty()) return folder.string() + ": has no *.csv, expected one for each trial";
    std::vector<core::SeaTrial> trials;
    std::string problems;
    for (const fs::path& file : files) {
        const auto text = files::readTextFile(file);
        auto trial = text ? core::readSeaTrial(file.filename().string(), *text)
                          : core::Result<core::SeaTrial, core::config::Problems>(core::config::Problems());
        if (trial)
            trials.push_back(std::move(trial).value());
        else
            problems += (problems.empty() ? "" : "\n") + (text ? trial.error().text() : text.error().message);
    }
    if (!problems.empty()) return problems;
    return trials;
}

}  // namespace sagara::tools
