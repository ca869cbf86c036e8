// A ship with two azimuth drives instead of screw and rudder: the tanker KVLCC2 rebuilt, for her model is
// mmg.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "BridgeShip.h"
#include "core/base/Units.h"
#include "core/motion/RungeKutta.h"
#include "tests/support/Assets.h"

namespace sagara::core {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

const OwnShip& rebuilt() {
    static const OwnShip ship = [] {
        std::string text = sagara::test::readAsset("vessels/kvlcc2.json");
        const std::size_t from = text.find("\"units\": ["), to = text.find("],\n    \"telegraph_rpm\"");
        const auto drive = [](const char* id, const char* y_m) {
            return std::string("{\"id\": \"") + id + "\", \"x_m\": -150, \"y_m\": " + y_m +
                   ", \"diameter_m\": 7.5, \"wageningenB\": {\"blades\": 4, \"areaRatio\": 0.55, "
                   "\"pitchRatio\": 0.9}, "
                   "\"wakeFraction\": 0.2, \"thrustDeduction\": 0.1, \"shaftRate_rpmps\": 5, "
                   "\"reversingTime_s\": 5, "
                   "\"azimuth\": {\"rate_degps\": 12}, \"engine\": {\"power_kW\": 12000, \"speed_rpm\": 110, "
                   "\"idle_rpm\": 20}}";
        };
        text.replace(from, to - from,
                     "\"units\": [" + drive("port", "-12") + ", " + drive("starboard", "12"));
        text = replaced(text, "[ { \"x_m\": -160.0, \"y_m\": 0.0 } ]", "[]");
        for (const char* member : {"\"areaEach_m2\": 112.5,", "\"liftSlope_perDeg\": 0.048,",
                                   "\"stallAngle_deg\": 45.0,", "\"raceShare\": 1.0,"})
            text = replaced(text, member, "");
        const char* const kSingleScrew = ",\n      \"astern\"";
        for (auto at = text.find(kSingleScrew); at != std::string::npos; at = text.find(kSingleScrew))
            text.erase(at, text.find('}', at) + 1 - at);
        auto vessel = loadVessel("azimuth.json", text);
        if (!vessel) throw std::runtime_error(vessel.error().text());
        return OwnShip("own", "Own", std::move(vessel).value());
    }();
    return ship;
}

class AzimuthShip : public ::testing::Test {
protected:
    void run(double for_s) {
        for (int i = 0; i < std::lround(for_s / kTick_s); ++i) {
            const Actuators actuators = runMachinery(ship, state, kTick_s);
            state.motion = rk4Step(state.motion, kTick_s, [&](const ShipMotion& m) {
                return ship.dynamics.derivative(m, actuators, {}, {});
            });
        }
    }
    const OwnShip& ship = rebuilt();
    OwnShipState state = startOf(ship);
};

TEST_F(AzimuthShip, IsSteeredByTheWheelThoughSheHasNoRudder) {
    obey(ship, state, TelegraphOrder{kAllShafts, TelegraphStep::HalfAhead});
    obey(ship, state, HelmOrder{20.0 * kDegree_rad});
    run(240.0);
    EXPECT_GT(state.motion.surge_mps, 0.5);
    EXPECT_GT(state.motion.heading_rad, 10.0 * kDegree_rad);
    EXPECT_GT(ship.turning.gain, 0.1);
}

TEST_F(AzimuthShip, PushesHerSternWhereTheDrivesPoint) {
    obey(ship, state, AzimuthOrder{kAllShafts, 90.0 * kDegree_rad});
    obey(ship, state, TelegraphOrder{kAllShafts, TelegraphStep::HalfAhead});
    run(120.0);
    EXPECT_NEAR(state.shafts[0].azimuth_rad, 90.0 * kDegree_rad, 1e-9);
    EXPECT_LT(state.motion.heading_rad, -3.0 * kDegree_rad) << "stern to starboard";
    EXPECT_LT(std::abs(state.motion.surge_mps), 0.5);
}

TEST_F(AzimuthShip, TurnsOnTheSpotWithOneDriveAheadAndOneAstern) {
    obey(ship, state, AzimuthOrder{1, 180.0 * kDegree_rad});
    obey(ship, state, TelegraphOrder{kAllShafts, TelegraphStep::HalfAhead});
    run(300.0);
    EXPECT_GT(state.motion.heading_rad, 1.0 * kDegree_rad);
    EXPECT_LT(std::abs(state.motion.surge_mps), 0.6);
}

TEST_F(AzimuthShip, GoesAsternWithHerDrivesTurnedRound) {
    obey(ship, state, AzimuthOrder{kAllShafts, 180.0 * kDegree_rad});
    obey(ship, state, TelegraphOrder{kAllShafts, TelegraphStep::HalfAhead});
    run(300.0);
    EXPECT_LT(state.motion.surge_mps, -0.3);
}

}  // namespace
}  // namespace sagara::core
