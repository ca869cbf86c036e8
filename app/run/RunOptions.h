#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace sagara::run {

/// What `sagara-sim run` was asked to do.
struct RunOptions {
    std::string scenario;  ///< id or file
    bool pilot = false;    ///< the scripted pilot sails
    int level = 3;
    std::uint64_t seed = 1;
    std::optional<std::filesystem::path> commands;
    bool fast = false;
    std::optional<double> duration_s;
    std::string trainee;
    std::string type = "train";
    std::optional<std::filesystem::path> record;
    std::optional<std::filesystem::path> track;
    double track_Hz = 1.0;
    std::optional<std::filesystem::path> report;
    std::optional<std::filesystem::path> resume;
    bool json = false;
};

/// What `sagara-sim replay` was asked to do.
struct ReplayOptions {
    std::filesystem::path recording;
    std::optional<double> until_s;
    std::optional<std::filesystem::path> track;
    double track_Hz = 1.0;
    std::optional<std::filesystem::path> rubric;
    std::optional<std::filesystem::path> report;
    bool json = false;
};

/// Exit codes of the programs: 0 done (passed or not), 1 the machine failed, 2 what was asked cannot be done.
inline constexpr int kDone = 0, kMachineFailed = 1, kBadRequest = 2;

}  // namespace sagara::run
