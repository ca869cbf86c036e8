#include <benchmark/benchmark.h>

#include "core/base/Archive.h"
#include "core/exercise/Advance.h"
#include "core/exercise/BuildId.h"
#include "core/exercise/Prediction.h"
#include "core/exercise/Replay.h"
#include "core/exercise/Session.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

/// An exercise in Beaufort 5 after a minute, with as many active wave components as asked for.
struct Running {
    std::shared_ptr<const World> world;
    State state;

    Running(int ownShips, int targets, std::size_t components)
        : world(test::worldOf(test::openWaterScenario(ownShips, targets))), state(startState(*world, 3)) {
        for (int i = 0; i < 60 * kTicksPerSecond; ++i) (void)advance(*world, state);
        SeaState& sea = state.weather.sea;
        components = std::min(components, sea.active.size());
        sea.active.resize(components);
        sea.amplitude_m.resize(components);
    }
};

/// Seconds of simulation per second of one core.
void rate(benchmark::State& bench, std::int64_t ticks) {
    bench.counters["xRealTime"] =
        benchmark::Counter(static_cast<double>(ticks) * kTick_s, benchmark::Counter::kIsRate);
}

void advanceBeaufort5(benchmark::State& bench) {
    Running run(static_cast<int>(bench.range(0)), static_cast<int>(bench.range(1)), 200);
    std::int64_t ticks = 0;
    for (auto _ : bench) {
        benchmark::DoNotOptimize(advance(*run.world, run.state));
        ++ticks;
    }
    bench.counters["components"] = static_cast<double>(run.state.weather.sea.active.size());
    rate(bench, ticks);
}
BENCHMARK(advanceBeaufort5)->Args({1, 20})->Args({1, 0})->Args({2, 50})->ArgNames({"ownShips", "targets"});

void copyState(benchmark::State& bench) {
    const Running run(1, 20, 400);
    for (auto _ : bench) {
        State copy = run.state;
        benchmark::DoNotOptimize(copy);
    }
    bench.counters["stateBytes"] = static_cast<double>(toBytes(run.state).size());
}
BENCHMARK(copyState);

/// The own ship's track of the next six minutes from a copy of the State.
void predict6min(benchmark::State& bench) {
    const Running run(1, 20, 200);
    for (auto _ : bench) benchmark::DoNotOptimize(predict(*run.world, run.state, 0, 360.0, 10.0));
}
BENCHMARK(predict6min)->Unit(benchmark::kMillisecond);

/// The whole lesson with its pilot, recorded.
void lessonRecorded(benchmark::State& bench) {
    const auto world = test::lessonWorld();
    double sailed_s = 0.0;
    for (auto _ : bench) {
        Bytes bytes;
        RecordingWriter writer([&](std::span<const std::byte> piece) { append(bytes, piece); });
        RecordingHeader header;
        header.documents = world->documents;
        Session session(world, startState(*world, 3), {{0, 0, PilotOrder{true}}}, &writer);
        writer.begin(header, *world, session.state());
        while (!session.over()) (void)session.step();
        writer.end(session.state());
        sailed_s += session.state().time().seconds();
        bench.counters["recordingMB"] = static_cast<double>(bytes.size()) / 1e6;
    }
    bench.counters["xRealTime"] = benchmark::Counter(sailed_s, benchmark::Counter::kIsRate);
}
BENCHMARK(lessonRecorded)->Unit(benchmark::kMillisecond)->Iterations(3);

/// To a second of a recorded half hour, worst case: just before the next stored state.
void seek(benchmark::State& bench) {
    const auto world = test::worldOf(test::openWaterScenario(2, 20));
    Bytes bytes;
    RecordingWriter writer([&](std::span<const std::byte> piece) { append(bytes, piece); });
    RecordingHeader header;
    header.buildId = coreBuildId();
    header.documents = world->documents;
    Session session(world, startState(*world, 3), {}, &writer);
    writer.begin(header, *world, session.state());
    while (session.state().tick < 1800 * kTicksPerSecond) (void)session.step();
    writer.end(session.state());
    const auto recording = readRecording(bytes);
    for (auto _ : bench) benchmark::DoNotOptimize(stateAt(*world, *recording, 1789 * kTicksPerSecond));
    bench.counters["MBperHour"] = 2.0 * static_cast<double>(bytes.size()) / 1e6;
}
BENCHMARK(seek)->Unit(benchmark::kMillisecond)->Iterations(20);

void buildLesson(benchmark::State& bench) {
    const auto documents = test::documentsOf(test::lessonText());
    for (auto _ : bench) benchmark::DoNotOptimize(buildWorld(documents, 1));
}
BENCHMARK(buildLesson)->Unit(benchmark::kMillisecond)->Iterations(5);

}  // namespace
}  // namespace sagara::core
