#include "app/replay/BranchRun.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "app/files/Files.h"
#include "app/replay/NotesFile.h"
#include "core/base/Units.h"
#include "core/exercise/Replay.h"
#include "db/RunRepository.h"
#include "tests/support/replay/SampleRecording.h"

namespace sagara::replay {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr std::int64_t kFrom = 60 * core::kTicksPerSecond;

class WhatIf : public ::testing::Test {
protected:
    void SetUp() override {
        m_folder = fs::temp_directory_path() / ("sagara-whatif-" + std::to_string(::getpid()));
        fs::remove_all(m_folder);
        auto store = run::Store::open(m_folder);
        ASSERT_TRUE(store) << store.error();
        m_store = std::move(store).value();
        m_file = m_folder / "original.sgr";
        test::recordLesson(m_file, test::livelyCommands(), 90.0);
        auto film = openFilm(m_file, [](double) { return true; });
        ASSERT_TRUE(film) << film.error();
        m_film = std::move(film).value();
        auto state = core::stateAt(*m_film->world, m_film->recording, kFrom);
        ASSERT_TRUE(state) << state.error();
        m_from = std::move(state).value();
    }
    void TearDown() override {
        m_store.reset();
        fs::remove_all(m_folder);
    }
    std::unique_ptr<BranchRun> branch() {
        auto opened = BranchRun::open(*m_store, m_film, m_from);
        EXPECT_TRUE(opened) << opened.error();
        return opened ? std::move(opened).value() : nullptr;
    }
    static void sail(BranchRun& run, double until_s) {
        run.setRate(20.0);
        run.start();
        for (int i = 0; i < 2000 && run.latest()->time().seconds() < until_s; ++i)
            std::this_thread::sleep_for(10ms);
        run.freeze();
        EXPECT_GE(run.latest()->time().seconds(), until_s);
    }

    fs::path m_folder, m_file;
    std::unique_ptr<run::Store> m_store;
    std::shared_ptr<const Film> m_film;
    core::State m_from;
};

TEST_F(WhatIf, BeginsInTheStateOfTheSecondItLeaves) {
    const auto run = branch();
    EXPECT_EQ(core::stateHash(run->state()), core::stateHash(m_from));
    EXPECT_EQ(run->from(), core::timeOfTick(kFrom));
    EXPECT_FALSE(run->running());
}

TEST_F(WhatIf, TheOriginalStaysAsItIsAndTheBranchReplaysAsARunOfItsOwn) {
    const auto before = files::readBinaryFile(m_file);
    fs::path recording;
    std::uint64_t end = 0;
    {
        const auto run = branch();
        run->give(0, core::HelmOrder{-20.0 * core::kDegree_rad});
        run->give(0, core::PilotOrder{false});
        sail(*run, 75.0);
        EXPECT_FALSE(run->finish().empty());
        EXPECT_TRUE(run->finished());
        EXPECT_TRUE(run->trouble().empty()) << run->trouble();
        recording = run->recording();
        end = core::stateHash(run->state());
    }
    EXPECT_EQ(*files::readBinaryFile(m_file), *before);

    const auto bytes = files::readBinaryFile(recording);
    ASSERT_TRUE(bytes);
    const auto read = core::readRecording(*bytes);
    ASSERT_TRUE(read) << read.error();
    EXPECT_TRUE(read->damage.empty()) << read->damage;
    EXPECT_EQ(read->header.runType, "train");
    EXPECT_TRUE(read->header.planned.empty());
    EXPECT_EQ(read->states.front().tick, 0) << "it holds the part before";
    const auto at = core::stateAt(*m_film->world, *read, kFrom);
    ASSERT_TRUE(at) << at.error();
    EXPECT_EQ(core::stateHash(*at), core::stateHash(m_from));
    const auto last = core::replay(*m_film->world, *read, read->endTick, [](auto&&...) {});
    ASSERT_TRUE(last) << last.error();
    EXPECT_EQ(core::stateHash(*last), end);
    EXPECT_NE(core::stateHash(*core::stateAt(*m_film->world, m_film->recording, 75 * core::kTicksPerSecond)),
              core::stateHash(*core::stateAt(*m_film->world, *read, 75 * core::kTicksPerSecond)));
    const auto runs = db::RunRepository(*m_store->database()).list();
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(runs[0].start.type, db::RunType::Train);
    EXPECT_FALSE(runs[0].start.person.has_value());
}

TEST_F(WhatIf, WithoutNewOrdersItSailsAsRecordedUntilTheNextCommand) {
    const auto run = branch();
    sail(*run, 68.0);
    const auto track = run->track();
    ASSERT_GT(track.size(), 30u);
    EXPECT_EQ(track.front().tick, kFrom);
    for (const core::TrackSample& sample : track) {
        if (sample.tick > 69 * core::kTicksPerSecond) break;  // the recorded helm was taken at 70 s
        const auto& original = m_film->track[static_cast<std::size_t>(sample.tick / core::kTrackEvery_ticks)];
        ASSERT_EQ(original.tick, sample.tick);
        EXPECT_LT(core::distance(original.ships[0].motion.position(), sample.ships[0].motion.position()),
                  0.011)
            << sample.tick;
    }
}

TEST_F(WhatIf, NotesAreKeptBesideTheRecording) {
    const NotesFile notes(m_file);
    EXPECT_TRUE(notes.read().empty());
    EXPECT_FALSE(notes.add({{30'000'000}, "späte Ansage"}));
    EXPECT_FALSE(notes.add({{12'500'000}, "line \"aft\" slack"}));
    const auto read = notes.read();
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0].time.us, 12'500'000);
    EXPECT_EQ(read[1].text, "späte Ansage");
    ASSERT_FALSE(files::writeTextFile(notes.path(), "{\"document\": 7}"));
    EXPECT_TRUE(notes.read().empty());
    EXPECT_TRUE(notes.add({{0}, "x"})) << "what cannot be read is not written over";
    EXPECT_EQ(*files::readTextFile(notes.path()), "{\"document\": 7}");
}

}  // namespace
}  // namespace sagara::replay
