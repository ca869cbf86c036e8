#include "app/run/Outputs.h"

#include <algorithm>
#include <cmath>

#include "app/files/Files.h"
#include "app/run/Console.h"
#include "app/run/FillReport.h"

namespace sagara::run {

TrackOutput::TrackOutput(const core::World& world, const std::optional<std::filesystem::path>& path,
                         double rate_Hz)
    : m_world(world),
      m_path(path),
      m_every_ticks(std::max<std::int64_t>(1, std::llround(core::kTicksPerSecond / rate_Hz))),
      m_csv(world) {}

void TrackOutput::add(const core::State& state) {
    if (m_path && state.tick % m_every_ticks == 0) m_csv.add(core::sampleOf(m_world, state));
}

void TrackOutput::add(const core::TrackSample& sample) {
    if (m_path && sample.tick % m_every_ticks == 0) m_csv.add(sample);
}

bool TrackOutput::write() const {
    if (!m_path) return true;
    const auto failed = files::writeTextFile(*m_path, m_csv.text());
    if (failed) tell(failed->message);
    return !failed;
}

bool writeReportOf(const core::World& world, const core::Mission& mission, const core::Recording& recording,
                   const RunSummary& summary, const std::filesystem::path& path) {
    try {
        report::writeReport(fillReport(world, mission, recording, summary), path.string());
        return true;
    } catch (const std::exception& e) {
        tell(e.what());
        return false;
    }
}

void printSummary(const RunSummary& summary, bool json) {
    print(json ? toJson(summary) + "\n" : toText(summary));
}

}  // namespace sagara::run
