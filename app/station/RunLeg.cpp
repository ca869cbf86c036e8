#include "app/station/RunLeg.h"

namespace sagara::station {

RunLeg::RunLeg(run::Store& store, std::shared_ptr<const core::World> world,
               std::unique_ptr<run::RecordingFile> file, core::RecordingHeader header)
    : m_world(std::move(world)),
      m_file(std::move(file)),
      m_header(std::move(header)),
      m_filing(store),
      m_run(m_filing.newRun(m_header, *m_world, m_file->path())),
      m_writer([this](std::span<const std::byte> bytes) { write(bytes); }) {}

void RunLeg::write(std::span<const std::byte> bytes) {
    m_file->write(bytes);
    const std::lock_guard lock(m_mutex);
    m_recordingTrouble = m_file->trouble();
}

void RunLeg::sail(core::State start, std::vector<core::Event> past) {
    m_live = std::make_unique<live::LiveRun>(m_world, std::move(start), m_header.planned, &m_writer,
                                             std::move(past));
}

core::Result<std::unique_ptr<RunLeg>, std::string> RunLeg::begin(run::Store& store,
                                                                 std::shared_ptr<const core::World> world,
                                                                 core::RecordingHeader header) {
    std::string trouble;
    auto file = run::RecordingFile::open(run::newRecordingPath(store, world->scenarioId), 0, trouble);
    if (!file) return trouble;
    auto leg = std::unique_ptr<RunLeg>(new RunLeg(store, world, std::move(file), std::move(header)));
    core::State start = core::startState(*world, leg->m_header.level);
    leg->m_writer.begin(leg->m_header, *world, start);
    leg->m_filingTrouble = leg->m_filing.begin(leg->m_run);
    leg->sail(std::move(start), {});
    return leg;
}

core::Result<std::unique_ptr<RunLeg>, std::string> RunLeg::takeUp(run::Store& store,
                                                                  const std::filesystem::path& recording) {
    auto found = run::takeUp(recording, store.hulls());
    if (!found) return found.error();
    run::TakenUp taken = std::move(found).value();
    std::string trouble;
    auto file = run::RecordingFile::open(recording, taken.whole_bytes, trouble);
    if (!file) return trouble;
    auto leg = std::unique_ptr<RunLeg>(
        new RunLeg(store, std::move(taken.world), std::move(file), std::move(taken.header)));
    leg->m_writer.goOn(taken.state);
    leg->m_sailedBefore = std::move(taken.track);
    leg->sail(std::move(taken.state), std::move(taken.events));
    return leg;
}

core::Result<std::unique_ptr<RunLeg>, std::string> RunLeg::sailAgain(run::Store& store, run::SetBack back) {
    const std::shared_ptr<const core::World> world = back.run.world;
    std::string trouble;
    auto file = run::RecordingFile::open(run::newRecordingPath(store, world->scenarioId), 0, trouble);
    if (!file) return trouble;
    auto leg = std::unique_ptr<RunLeg>(new RunLeg(store, world, std::move(file), std::move(back.run.header)));
    leg->write(back.recording);
    leg->m_writer.goOn(back.run.state);
    leg->m_filingTrouble = leg->m_filing.begin(leg->m_run);
    leg->m_sailedBefore = std::move(back.run.track);
    leg->sail(std::move(back.run.state), std::move(back.run.events));
    return leg;
}

std::string RunLeg::trouble() const {
    const std::lock_guard lock(m_mutex);
    return m_recordingTrouble.empty() ? m_filingTrouble : m_recordingTrouble;
}

const run::RunSummary& RunLeg::end() {
    if (m_summary) return *m_summary;
    m_live->stop();
    const core::State state = m_live->state();
    m_writer.end(state);
    m_summary = run::summarise(*m_world, m_world->mission, state.assessment,
                               run::assessmentEvents(m_live->eventsFrom(0)));
    m_summary->simTime_s = state.time().seconds();
    m_summary->stateHash = core::toHex(core::stateHash(state));
    m_filingTrouble = m_filing.end(m_run, *m_summary, state.finished);
    return *m_summary;
}

}  // namespace sagara::station
