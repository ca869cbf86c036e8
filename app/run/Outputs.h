#pragma once

#include <filesystem>
#include <optional>

#include "app/run/RunSummary.h"
#include "app/run/TrackCsv.h"
#include "core/exercise/Recording.h"

namespace sagara::run {

/// Gathers the track file while a run goes on, at the rate asked for; nothing when no file was.
class TrackOutput {
public:
    TrackOutput(const core::World& world, const std::optional<std::filesystem::path>& path, double rate_Hz);
    void add(const core::State& state);
    void add(const core::TrackSample& sample);
    /// False, and the trouble told, when it cannot be written.
    bool write() const;

private:
    const core::World& m_world;
    std::optional<std::filesystem::path> m_path;
    std::int64_t m_every_ticks;
    TrackCsv m_csv;
};

/// Writes the report of a recording. False, and the trouble told, when it cannot be written.
bool writeReportOf(const core::World& world, const core::Mission& mission, const core::Recording& recording,
                   const RunSummary& summary, const std::filesystem::path& path);

/// Prints the summary as asked.
void printSummary(const RunSummary& summary, bool json);

}  // namespace sagara::run
