#pragma once

#include <filesystem>
#include <functional>

#include "core/exercise/Recording.h"

namespace sagara::test {

/// Sails the lesson with these commands for so long and keeps the recording. `after` sees every tick.
void recordLesson(const std::filesystem::path& file, std::vector<core::Command> planned, double until_s,
                  const std::function<void(const core::State&)>& after = nullptr);

/// The pilot sails; at 30 s rain and wind are ordered, at 40 s a bookmark is made, at 70 s the helm is taken.
std::vector<core::Command> livelyCommands();

/// The run of assets/commands/basic-navigation-bad-run.json: 25 min with deductions. Takes a second or two.
void recordBadRun(const std::filesystem::path& file);

}  // namespace sagara::test
