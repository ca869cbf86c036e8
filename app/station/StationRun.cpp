#include "app/station/StationRun.h"

#include "app/files/BuildScenario.h"
#include "db/PersonRepository.h"

namespace sagara::station {

core::Result<std::unique_ptr<StationRun>, std::string> StationRun::open(run::Store& store,
                                                                        const RunRequest& request) {
    std::string trainee;
    if (!request.trainee.empty()) {
        const auto name = db::personName(request.trainee);
        if (!name) return std::string(db::toText(name.error()));
        trainee = name.value();
    }
    auto world = files::buildScenario(store, request.scenario, request.seed);
    if (!world) return world.error();
    core::RecordingHeader header = run::newHeader(**world, request.level, request.type, trainee);
    if (request.pilot) header.planned.push_back({0, 0, core::PilotOrder{true}});
    std::string trouble;
    auto file = run::RecordingFile::open(run::newRecordingPath(store, (*world)->scenarioId), 0, trouble);
    if (!file) return trouble;
    return std::unique_ptr<StationRun>(
        new StationRun(store, std::move(world).value(), std::move(file), std::move(header)));
}

StationRun::StationRun(run::Store& store, std::shared_ptr<const core::World> world,
                       std::unique_ptr<run::RecordingFile> file, core::RecordingHeader header)
    : m_world(std::move(world)),
      m_file(std::move(file)),
      m_filing(store),
      m_run(m_filing.newRun(header, *m_world, m_file->path())),
      m_writer([this](std::span<const std::byte> bytes) {
          m_file->write(bytes);
          const std::lock_guard lock(m_mutex);
          m_recordingTrouble = m_file->trouble();
      }) {
    core::State start = core::startState(*m_world, header.level);
    m_writer.begin(header, *m_world, start);
    m_filingTrouble = m_filing.begin(m_run);
    m_live = std::make_unique<live::LiveRun>(m_world, std::move(start), header.planned, &m_writer);
}

StationRun::~StationRun() { end(); }

ui::ExerciseRun::Picture StationRun::toDraw() {
    wall::Moment moment = m_live->toDraw();
    return {moment.time, std::move(moment.snapshot)};
}

std::string StationRun::trouble() const {
    const std::lock_guard lock(m_mutex);
    return m_recordingTrouble.empty() ? m_filingTrouble : m_recordingTrouble;
}

const run::RunSummary& StationRun::end() {
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
