#include <benchmark/benchmark.h>

#include <memory>

#include "core/sea/Beaufort.h"
#include "core/seakeeping/FloatingHull.h"
#include "core/seakeeping/MakeTables.h"
#include "core/seakeeping/WaveExcitation.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

/// Tables of a new hull of 41 stations: 36 frequencies of encounter, 64 waves from 25 headings at 5 speeds.
void seakeepingTablesOfAHull(benchmark::State& state) {
    const HullForm form =
        readHullForm("dtmb5415", test::readReferenceText("seakeeping/dtmb5415_hull.json")).value();
    for (auto _ : state) benchmark::DoNotOptimize(makeTables(form));
}
BENCHMARK(seakeepingTablesOfAHull)->Unit(benchmark::kMillisecond);

/// Seconds of the sea's forces and of the six equations with their memory in one step of 20 ms, 200
/// components.
void stepOfAHullIn200Waves(benchmark::State& state) {
    const HullForm form =
        readHullForm("dtmb5415", test::readReferenceText("seakeeping/dtmb5415_hull.json")).value();
    const SeakeepingTables tables = makeTables(form);
    const WaveExcitation excitation(tables);
    const FloatingHull hull(tables);
    const WaveTable table(1, 100.0);
    SeaState sea{{*windSea(windOfBeaufort_mps(8), 0.6, Exposure::Inshore)}, {}, {}};
    raiseSea(table, sea);
    sea.active.resize(200);
    sea.amplitude_m.resize(200);
    const auto waves = std::make_unique<ActiveWaves>();
    activeWaves(table, sea, SimTime::fromSeconds(600), *waves);
    double heading = 0.3;
    for (auto _ : state) {
        const WaveForces forces = excitation.force(*waves, {400.0, 300.0}, heading, 6.0, 1.0);
        HullMotion motion;
        for (int stage = 0; stage < 4; ++stage)
            motion = motion + 0.01 * hull.rate(motion, forces.first, 6.0, tables.viscousRoll[1]);
        benchmark::DoNotOptimize(motion);
        heading += 1e-6;
    }
}
BENCHMARK(stepOfAHullIn200Waves);

}  // namespace
}  // namespace sagara::core
