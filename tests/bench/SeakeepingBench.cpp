#include <benchmark/benchmark.h>

#include "core/seakeeping/MakeTables.h"
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

}  // namespace
}  // namespace sagara::core
