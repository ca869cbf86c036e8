#include "app/run/RunFiling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/files/Files.h"
#include "app/run/GradeRecording.h"
#include "app/run/RecordingFile.h"
#include "core/exercise/BuildId.h"
#include "core/exercise/Replay.h"
#include "db/PersonRepository.h"
#include "db/RunRepository.h"

namespace sagara::run {
namespace fs = std::filesystem;
namespace {

constexpr int kLooked = 50;  ///< the newest runs

/// Does something with the database; the message of what went wrong, or empty.
template <typename Do>
std::string attempt(Store& store, Do&& act) {
    if (!store.database()) return store.trouble();
    try {
        act(*store.database());
        return {};
    } catch (const db::DbError& e) {
        return e.what();
    }
}

std::optional<db::PersonId> personOf(db::Database& database, const std::string& name) {
    if (name.empty()) return std::nullopt;
    db::PersonRepository people(database);
    if (const auto known = people.findByName(name)) return known->id;
    const auto added = people.add(name, db::Role::Trainee, now());
    return added ? std::optional(added.value()) : std::nullopt;
}

/// X.unfiled, or X-2.unfiled and so on where that speaks of another recording of the same file name.
fs::path notePath(const fs::path& recording, const std::string& text) {
    for (int i = 1;; ++i) {
        fs::path path = recording;
        path += i == 1 ? ".unfiled" : fmt::format("-{}.unfiled", i);
        const auto known = files::readTextFile(path);
        if (!known || *known == text) return path;
    }
}

std::string told(const std::string& recording, const std::string& failed) {
    if (failed.empty()) return "Filed the earlier run " + recording + ".";
    return "The earlier run " + recording + " still cannot be filed: " + failed;
}

db::EndedRun endedRun(const db::NewRun& run, const RunSummary& summary, bool finished) {
    db::EndedRun ended;
    ended.start = run;
    ended.result.status = finished ? db::RunStatus::Finished : db::RunStatus::Aborted;
    ended.result.finished = now();
    ended.result.simTime = {std::llround(summary.simTime_s * 1e6)};
    ended.result.stateHash = std::stoull(summary.stateHash, nullptr, 16);
    db::Grade grade;
    grade.score = summary.score;
    grade.passed = summary.passed;
    grade.tasks = tasksJson(summary);
    grade.deductions = deductionsJson(summary);
    grade.made = now();
    ended.grade = grade;
    return ended;
}

}  // namespace

db::NewRun RunFiling::newRun(const core::RecordingHeader& header, const core::World& world,
                             const fs::path& recording) {
    db::NewRun run;
    run.scenarioKey = world.scenarioId;
    run.scenarioName = world.scenarioName;
    run.type = db::parseRunType(header.runType).value_or(db::RunType::Train);
    run.level = header.level;
    run.seed = header.seed;
    run.buildId = header.buildId;
    run.started = {header.startedUnix_s};
    run.recordingFile = m_store.folder().nameOf(recording);
    attempt(m_store, [&](db::Database& database) { run.person = personOf(database, header.trainee); });
    return run;
}

std::string RunFiling::begin(const db::NewRun& run) {
    return attempt(m_store, [&](db::Database& database) { db::beginRun(database, run); });
}

std::string RunFiling::end(const db::NewRun& run, const RunSummary& summary, bool finished) {
    const std::string failed = attempt(
        m_store, [&](db::Database& database) { db::fileRun(database, endedRun(run, summary, finished)); });
    if (failed.empty()) return {};
    return failed + "\n" + note(run.recordingFile);
}

std::string RunFiling::note(const std::string& recordingName) {
    const fs::path recording = m_store.folder().pathOf(recordingName);
    const std::string text = recordingName + "\n";
    const auto failed =
        files::writeTextFile(notePath(m_store.folder().recordings() / recording.filename(), text), text);
    if (failed)
        return "The run is kept in " + recording.string() +
               " but could not be noted for filing: " + failed->message;
    return "The run is kept in " + recording.string() + " and will be filed at a later start.";
}

std::string RunFiling::fileFromRecording(const fs::path& path) {
    auto bytes = files::readBinaryFile(path);
    if (!bytes) return bytes.error().message;
    const auto recording = core::readRecording(*bytes);
    if (!recording) return path.string() + ": " + recording.error();
    const auto world = core::worldOf(*recording, m_store.hulls());
    if (!world) return world.error().text();
    const RunSummary summary = gradeRecording(**world, *recording, recording->endTick);
    const db::NewRun run = newRun(recording->header, **world, path);
    return attempt(m_store, [&](db::Database& database) {
        db::fileRun(database, endedRun(run, summary, recording->end && recording->end->finished));
    });
}

std::vector<std::string> RunFiling::fileNoted() {
    std::vector<std::string> messages;
    if (!m_store.database()) return messages;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(m_store.folder().recordings(), ignored)) {
        if (entry.path().extension() != ".unfiled") continue;
        auto name = files::readTextFile(entry.path());
        if (!name) continue;
        std::string recording = std::move(name).value();
        while (!recording.empty() && recording.back() == '\n') recording.pop_back();
        const std::string failed = fileFromRecording(m_store.folder().pathOf(recording));
        if (failed.empty()) fs::remove(entry.path(), ignored);
        messages.push_back(told(recording, failed));
    }
    for (const std::string& recording : endedUnfiled())
        messages.push_back(told(recording, fileFromRecording(m_store.folder().pathOf(recording))));
    return messages;
}

/// Names of recordings: their folder was away when they ended, so that no note could be left.
std::vector<std::string> RunFiling::endedUnfiled() {
    std::vector<std::string> names;
    attempt(m_store, [&](db::Database& database) {
        for (const db::RunRecord& run : db::RunRepository(database).list({kLooked, 0})) {
            if (run.status != db::RunStatus::Running) continue;
            const fs::path path = m_store.folder().pathOf(run.start.recordingFile);
            if (RecordingFile::isBeingWritten(path)) continue;
            const auto bytes = files::readBinaryFile(path);
            const auto recording = bytes ? std::optional(core::readRecording(*bytes)) : std::nullopt;
            if (recording && *recording && (*recording)->end) names.push_back(run.start.recordingFile);
        }
    });
    return names;
}

core::RecordingHeader newHeader(const core::World& world, int level, std::string runType,
                                std::string trainee) {
    core::RecordingHeader header;
    header.buildId = core::coreBuildId();
    header.seed = world.seed;
    header.level = level;
    header.runType = std::move(runType);
    header.trainee = std::move(trainee);
    header.startedUnix_s = now().unix_s;
    header.documents = world.documents;
    return header;
}

std::filesystem::path newRecordingPath(const Store& store, const std::string& scenario) {
    std::string stamp = core::formatUtc(now());
    stamp.erase(std::remove_if(stamp.begin(), stamp.end(), [](char c) { return c == '-' || c == ':'; }),
                stamp.end());
    for (int i = 1;; ++i) {
        const std::filesystem::path path =
            store.folder().recordings() / fmt::format("{}-{}-{}.sgr", stamp, scenario, i);
        if (!std::filesystem::exists(path)) return path;
    }
}

}  // namespace sagara::run
