#include <benchmark/benchmark.h>

#include <memory>

#include "core/motion/ShipDynamics.h"
#include "core/sea/Beaufort.h"
#include "tests/support/Assets.h"
#include "tests/support/hulls/Tables.h"

namespace sagara::core {
namespace {

/// Six wave loads on one ship, as many components as the argument says.
void sixWaveLoads(benchmark::State& state) {
    const WaveTable table(1, 20.0);
    const Vessel vessel = loadVessel("patrol51.json", test::readAsset("vessels/patrol51.json")).value();
    const ShipDynamics ship(vessel, {}, test::seaHulls()->of(vessel.hull));
    SeaState sea{{*windSea(windOfBeaufort_mps(5), 0.6, Exposure::Inshore)}, {}, {}};
    raiseSea(table, sea);
    sea.active.resize(static_cast<std::size_t>(state.range(0)));
    sea.amplitude_m.resize(sea.active.size());
    const auto waves = std::make_unique<ActiveWaves>();
    activeWaves(table, sea, SimTime::fromSeconds(600), *waves);
    ShipMotion moving;
    moving.north_m = 400.0;
    moving.heading_rad = 0.3;
    moving.surge_mps = 6.0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(ship.wavesAt(*waves, moving, 1.0));
        moving.heading_rad += 1e-6;
    }
}
BENCHMARK(sixWaveLoads)->Arg(100)->Arg(200);

}  // namespace
}  // namespace sagara::core
