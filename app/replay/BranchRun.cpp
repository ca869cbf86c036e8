#include "app/replay/BranchRun.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/files/Files.h"
#include "core/exercise/RecordingBranch.h"

namespace sagara::replay {

struct BranchRun::Beginning {
    core::State from;
    core::RecordingHeader header;
    core::Bytes bytes;  ///< of its recording up to there
    std::unique_ptr<run::RecordingFile> file;
};

core::Result<std::unique_ptr<BranchRun>, std::string> BranchRun::open(run::Store& store,
                                                                      std::shared_ptr<const Film> film,
                                                                      core::State from) {
    const auto original = files::readBinaryFile(film->file);
    if (!original) return original.error().message;
    Beginning b;
    b.header = run::newHeader(*film->world, film->recording.header.level, "train", {});
    auto bytes = core::recordingUpTo(*original, b.header, from.tick);
    if (!bytes) return film->file.filename().string() + ": " + bytes.error();
    b.bytes = std::move(bytes).value();
    std::string trouble;
    b.file = run::RecordingFile::open(run::newRecordingPath(store, film->world->scenarioId), 0, trouble);
    if (!b.file) return trouble;
    b.from = std::move(from);
    return std::unique_ptr<BranchRun>(new BranchRun(store, std::move(film), std::move(b)));
}

BranchRun::BranchRun(run::Store& store, std::shared_ptr<const Film> film, Beginning b)
    : m_film(std::move(film)),
      m_from(b.from.tick),
      m_file(std::move(b.file)),
      m_filing(store),
      m_run(m_filing.newRun(b.header, *m_film->world, m_file->path())),
      m_writer([this](std::span<const std::byte> bytes) { write(bytes); }) {
    write(b.bytes);
    m_writer.goOn(b.from);
    m_filingTrouble = m_filing.begin(m_run);
    m_live = std::make_unique<live::LiveRun>(m_film->world, std::move(b.from), std::vector<core::Command>{},
                                             &m_writer);
}

BranchRun::~BranchRun() { finish(); }

void BranchRun::write(std::span<const std::byte> bytes) {
    m_file->write(bytes);
    const std::lock_guard lock(m_mutex);
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
    m_recordingTrouble = m_file->trouble();
}

ui::ExerciseRun::Picture BranchRun::toDraw() {
    wall::Moment moment = m_live->toDraw(m_clock);
    return {moment.time, std::move(moment.snapshot)};
}

std::string BranchRun::trouble() const {
    const std::lock_guard lock(m_mutex);
    return m_recordingTrouble.empty() ? m_filingTrouble : m_recordingTrouble;
}

std::vector<core::TrackSample> BranchRun::track() const {
    core::Bytes bytes;
    {
        const std::lock_guard lock(m_mutex);
        bytes = m_bytes;
    }
    const auto recording = core::readRecording(bytes);
    if (!recording) return {};
    auto track = recording->track(m_film->world->ships.size(), m_film->world->targets.size());
    const auto since = std::find_if(track.begin(), track.end(),
                                    [this](const auto& sample) { return sample.tick >= m_from; });
    track.erase(track.begin(), since);
    return track;
}

const std::string& BranchRun::finish() {
    if (m_outcome) return *m_outcome;
    m_live->stop();
    const core::State state = m_live->state();
    m_writer.end(state);
    std::vector<core::Event> events;
    for (const core::Event& e : m_film->recording.events)
        if (e.tick <= m_from) events.push_back(e);
    const auto since = m_live->eventsFrom(0);
    events.insert(events.end(), since.begin(), since.end());
    run::RunSummary summary = run::summarise(*m_film->world, m_film->world->mission, state.assessment,
                                             run::assessmentEvents(events));
    summary.simTime_s = state.time().seconds();
    summary.stateHash = core::toHex(core::stateHash(state));
    m_filingTrouble = m_filing.end(m_run, summary, state.finished);
    m_outcome = fmt::format("{}, score {:.0f} of 100 (automatic, advisory)",
                            summary.passed ? "passed" : "not passed, " + summary.whyNot, summary.score);
    return *m_outcome;
}

}  // namespace sagara::replay
