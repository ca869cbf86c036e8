#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "core/exercise/Advance.h"
#include "core/exercise/Forces.h"
#include "core/exercise/LocalWater.h"
#include "core/exercise/Snapshot.h"
#include "core/exercise/TickLoads.h"
#include "core/sea/SeaOrder.h"
#include "tests/support/Assets.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

std::string withSea(const std::string& sea) { return test::lessonWith("/weather/sea", sea); }

double heightOf(const State& state) {
    double energy = 0.0;
    for (const SeaSystem& s : state.weather.sea.systems)
        energy += s.significantHeight_m * s.significantHeight_m;
    return std::sqrt(energy);
}

std::string calmSea() { return test::with(test::lessonText(), "/weather/swells", "[]"); }

TEST(SeaDocument, AnySpectrumCanBeTheScenariosSea) {
    const std::pair<const char*, double> kSeas[] = {
        {R"({"spectrum": "bretschneider", "height_m": 2, "period_s": 8, "from_deg": 225})", 2.0},
        {R"({"spectrum": "ittc", "height_m": 2, "meanPeriod_s": 6, "from_deg": 225, "spreadingLaw": "cosN", "spreading": 2})",
         2.0},
        {R"({"spectrum": "jonswap", "height_m": 2, "period_s": 8, "gamma": 2.5, "from_deg": 225})", 2.0},
        {R"({"spectrum": "ochi-hubble", "height_m": 2, "from_deg": 225})", 2.0 * 0.99860},
        {R"({"spectrum": "pierson-moskowitz", "wind_kn": 20, "from_deg": 225})",
         fullyDeveloped(20 * kKnot_mps).significantHeight_m},
        {R"({"spectrum": "beaufort", "number": 6, "exposure": "ocean", "from_deg": 225})", 2.9}};
    for (const auto& [sea, height_m] : kSeas) {
        const auto world = test::worldOf(test::with(calmSea(), "/weather/sea", sea));
        const State state = startState(*world, 3);
        EXPECT_NEAR(heightOf(state), height_m * world->level(3).seaFactor, 1e-4) << sea;
        EXPECT_NEAR(wrapPi(state.weather.sea.systems[0].wavesTo_rad - 45.0 * kDegree_rad), 0.0, 1e-9);
    }
}

TEST(SeaDocument, AMeasuredSeaIsItsRecord) {
    const std::string document = test::readAsset("waves/ndbc-41010.json");
    const auto begin = document.find('{', document.find("\"records\"")), end = document.find('}', begin);
    const std::string record = document.substr(begin, end - begin + 1);
    const auto world = test::worldOf(test::with(
        calmSea(), "/weather/sea", std::string(R"({"spectrum": "measured", "record": )") + record + "}"));
    EXPECT_NEAR(heightOf(startState(*world, 3)), 0.83 * world->level(3).seaFactor, 0.05);
    EXPECT_GT(world->sea.size(), 20u);
}

TEST(SeaDocument, MistakesAreNamedWithTheirPath) {
    const std::string problems =
        test::problemsOf(withSea(R"({"spectrum": "jonswap", "height_m": 99, "from_deg": 10, "peak": 3})"));
    EXPECT_NE(problems.find("weather.sea.height_m"), std::string::npos) << problems;
    EXPECT_NE(problems.find("weather.sea.period_s"), std::string::npos);
    EXPECT_NE(problems.find("weather.sea.peak"), std::string::npos);
}

TEST(SeaDocument, TheSeaFollowsTheWindAgainOnceATrainerOrdersWind) {
    const auto world = test::worldOf(
        test::with(calmSea(), "/weather/sea",
                   R"({"spectrum": "jonswap", "height_m": 3, "period_s": 9, "from_deg": 225})"));
    State state = startState(*world, 3);
    WeatherOrder order;
    order.windSpeed_mps = 10.0;
    order.ramp_s = 10.0;
    (void)advance(*world, state, std::vector<Command>{{0, 0, order}});
    while (state.tick < 12 * kTicksPerSecond) (void)advance(*world, state);
    ASSERT_EQ(state.weather.sea.systems.size(), 1u);
    EXPECT_EQ(
        state.weather.sea.systems[0].significantHeight_m,
        windSea(10.0, state.weather.now.wind.windFrom_rad, state.weather.now.exposure)->significantHeight_m);
}

/// Open water, one tanker under way to the north at 8 kn, no waves and no wind.
std::string calmWater(const std::string& vessel = "esso-osaka") {
    std::string text = test::openWaterScenario(1, 0);
    text = test::with(text, "/ownShips/0/vessel", std::string("\"") + vessel + "\"");
    text = test::with(text, "/weather/wind/speed_kn", "0");
    text = test::with(text, "/weather/wind/gustiness", "0");
    return test::with(text, "/weather/swells", "[]");
}

/// A stream to the east that begins at a line north of the datum's middle and is whole 400 m farther.
std::string withStream(const std::string& text, double rate_mps) {
    std::string north, east;
    constexpr int kNodes = 201;
    for (int row = 0; row < kNodes; ++row) {
        for (int column = 0; column < 2; ++column) {
            const double there_m = -20'000.0 + 200.0 * row;
            const double share = std::clamp((there_m - 2000.0) / 400.0, 0.0, 1.0);
            if (!east.empty()) east += ",";
            east += std::to_string(rate_mps * share);
            north += north.empty() ? "0" : ",0";
        }
    }
    return test::with(
        text, "/weather/streams",
        std::string(R"({"source": "test", "fields": [{"southWest": {"north_m": -20000, "east_m": -20000},
        "spacing_m": 200, "rows": 201, "columns": 2, "unit": 1, "north": [)") +
            north + R"(], "east": [)" + east + "]}]}");
}

TEST(LocalCurrent, IsTheUniformOneWithoutStreams) {
    const auto world = test::lessonWorld();
    const State state = startState(*world, 3);
    EXPECT_EQ(currentAt(*world, state, {1234.0, 567.0}), state.weather.now.current);
}

TEST(LocalCurrent, ShipsAndTargetsFeelTheStreamWhereTheyAre) {
    // the raster is 200 m wide in the west: nothing else of the area is in it
    const auto world = test::worldOf(withStream(calmWater(), 1.0));
    State state = startState(*world, 3);
    state.weather.now.current = {0.2, 0.0};
    const NorthEast inside{10'000.0, -19'900.0}, outside{10'000.0, 0.0};
    EXPECT_NEAR(currentAt(*world, state, inside).east_m, 1.0, 1e-6);
    EXPECT_NEAR(currentAt(*world, state, inside).north_m, 0.2, 1e-12);
    EXPECT_NEAR(currentAt(*world, state, outside).east_m, 0.0, 1e-12);
    state.ships[0].motion.north_m = inside.north_m;
    state.ships[0].motion.east_m = inside.east_m;
    const WaterNow now(*world, state, state.time());
    EXPECT_NEAR(currentAt(*world, now, inside).east_m, 1.0, 1e-6);
    for (int i = 0; i < 50; ++i) (void)advance(*world, state);
    EXPECT_NEAR(view(*world, state).ships[0].overGround_mps.east_m -
                    HeadingFrame({}, state.ships[0].motion.heading_rad)
                        .vector({state.ships[0].motion.surge_mps, state.ships[0].motion.sway_mps})
                        .east_m,
                1.0, 1e-6);
}

TEST(LocalCurrent, AShipThatEntersAStreamIsCarriedOnlyAsFastAsItTakesHold) {
    const auto world = test::worldOf(withStream(calmWater(), 1.0));
    State state = startState(*world, 3);
    ShipMotion& m = state.ships[0].motion;
    m = {};
    m.north_m = 2200.0;  // half way in, all of her 325 m in the change
    m.east_m = -19'900.0;
    m.surge_mps = 5.0;
    const OwnShip& ship = *world->ships[0];
    const WaterNow now(*world, state, state.time());
    const Load load = streamLoad(*world, now, ship, m, 1e3);
    // bow in a stream to starboard: her mass holds her back, the water turns her bow to starboard
    ShipMotion turned = m;
    turned.yawRate_radps = -1.0 / 400.0;  // against the turning of the water
    const double hull_N = ship.dynamics.hullForces(turned, {}, 1e3).hull.sway_N -
                          ship.dynamics.hullForces(m, {}, 1e3).hull.sway_N;
    const double momentum_N = -ship.vessel.hull.mass_kg() * 5.0 * 1.0 / 400.0;  // -m u d(current)/dx
    EXPECT_NEAR(load.sway_N, momentum_N + hull_N, 1e-3 * std::abs(momentum_N));
    EXPECT_GT(load.yaw_Nm, 0.0);
    m.north_m = 15'000.0;  // in an even stream she feels nothing of it
    EXPECT_NEAR(streamLoad(*world, now, ship, m, 1e3).sway_N, 0.0, 1e-3);
}

std::string shallowGroup(const char* bank, const char* ships) {
    return std::string(R"({"squat": "yoshimura", "hull": "kijima", "bank": ")") + bank + R"(", "ships": ")" +
           ships + R"(", "source": "test", "quality": "estimated"})";
}

/// The scenario's world with the vessel's document changed.
std::shared_ptr<const World> worldWith(const std::string& scenario, const std::string& shallow) {
    ExerciseDocuments documents = test::documentsOf(scenario);
    for (NamedText& vessel : documents.vessels)
        vessel.text = test::with(vessel.text, "/shallowWater", shallow);
    auto world = buildWorld(documents, 1);
    if (!world) throw std::runtime_error(world.error().text());
    return std::move(world).value();
}

TEST(ConfinedWater, IsOnlyFeltWhereTheVesselsDocumentAsks) {
    const std::string text = test::openWaterScenario(2, 1);
    const auto plain = test::worldOf(text);
    State state = startState(*plain, 3);
    const WaterNow now(*plain, state, state.time());
    EXPECT_EQ(confinedLoad(*plain, state, 0, now, {}, 3.0).sway_N, 0.0);
    const auto asked = worldWith(text, shallowGroup("none", "none"));
    EXPECT_EQ(asked->ships[0]->keel.formula, SquatFormula::Yoshimura);
    state.ships[0].motion.surge_mps = 5.0;
    state.ships[0].motion.sway_mps = 0.5;
    const Load load = confinedLoad(*asked, state, 0, now, {}, 1.3 * asked->ships[0]->vessel.hull.draught_m);
    if (!asked->ships[0]->modelFeelsDepth) {
        EXPECT_LT(load.surge_N, 0.0);  // more resistance, and more against the drift
        EXPECT_LT(load.sway_N, 0.0);
    } else {
        EXPECT_EQ(load.sway_N, 0.0);
    }
}

TEST(ConfinedWater, OwnShipsAndTrafficFeelEachOther) {
    const auto world = worldWith(test::openWaterScenario(2, 1), shallowGroup("none", "slender-body"));
    State state = startState(*world, 3);
    const double length_m = world->ships[0]->vessel.hull.lengthBp_m;
    ShipMotion &a = state.ships[0].motion, &b = state.ships[1].motion;
    a.heading_rad = b.heading_rad = 0.0;
    b.north_m = a.north_m;
    b.east_m = a.east_m + 0.3 * length_m;
    a.surge_mps = b.surge_mps = 6.0;
    const WaterNow now(*world, state, state.time());
    const Load onA = confinedLoad(*world, state, 0, now, {}, 50.0),
               onB = confinedLoad(*world, state, 1, now, {}, 50.0);
    EXPECT_GT(onA.sway_N, 0.0);  // drawn together
    EXPECT_NEAR(onA.sway_N, -onB.sway_N, 1e-6 * onA.sway_N);

    TargetState& target = state.targets[0];
    target.present = true;
    target.position = a.position() + NorthEast{0.8 * length_m, -0.5 * length_m};
    target.heading_rad = 0.0;
    target.speed_mps = 5.0;
    const TargetState before = target;
    pushTarget(*world, state, targetLayout(*world, state, 0), target, now, 1.0);
    EXPECT_NE(target.yawRate_radps, before.yawRate_radps);
}

TEST(Wind, TheProfileTakesItToTheHeightOfTheWindage) {
    const std::string text = test::openWaterScenario(1, 0);
    const auto even = test::worldOf(text);
    const auto high = test::worldOf(test::with(text, "/weather/wind/profile", R"("froya")"));
    const State state = startState(*even, 3);
    const double z = even->ships[0]->vessel.windage.centroidHeight_m;
    const Load a = of(forcesOn(*even, state, 0), ForceCause::Wind),
               b = of(forcesOn(*high, state, 0), ForceCause::Wind);
    EXPECT_EQ(std::hypot(b.surge_N, b.sway_N) > std::hypot(a.surge_N, a.sway_N), z > 10.0);
}

TEST(Nearshore, WavesShoalAndBreakWhereTheAreaSaysSo) {
    ExerciseDocuments documents = test::documentsOf(test::openWaterScenario(1, 0));
    documents.area.text = test::with(documents.area.text, "/shoaling", "true");
    const auto world = buildWorld(documents, 1).value();
    State state = startState(*world, 3);
    const WaterNow now(*world, state, state.time());
    EXPECT_GT(now.waves.significantHeight_m(), 0.3);
    double least = 10.0;
    for (double north_m = -2000.0; north_m < 4000.0; north_m += 50.0) {
        const NorthEast p{north_m, 0.0};
        const double factor = now.waves.factorAt(p), depth_m = world->area.depth_m(p) + now.tide_m;
        EXPECT_LE(factor * now.waves.significantHeight_m(), 0.6 * std::max(depth_m, 0.0) + 0.05);
        least = std::min(least, factor);
    }
    EXPECT_EQ(least, 0.0);  // ashore
}

}  // namespace
}  // namespace sagara::core
