#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/Angle.h"
#include "core/bridge/ShaftControl.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/ShipDynamics.h"
#include "core/sea/Beaufort.h"
#include "tests/support/Assets.h"
#include "tests/support/ShippedVessels.h"
#include "tests/support/hulls/Tables.h"

namespace sagara::core {
namespace {

constexpr double kStep_s = 0.04, kHour_s = 3600.0;
constexpr int kCourses = 8;

/// A ship half ahead in the waves of Beaufort 8, steered from one course to the next all round the compass.
class Hour {
public:
    explicit Hour(const Vessel& vessel)
        : m_vessel(vessel),
          m_ship(m_vessel, {}, test::seaHulls()->of(m_vessel.hull)),
          m_sea{{*windSea(windOfBeaufort_mps(8), 0.6, Exposure::Ocean)}, {}, {}} {
        raiseSea(m_table, m_sea);
        m_actuators.shaft_rps.fill(
            m_vessel.propulsion.telegraph_rps[static_cast<std::size_t>(TelegraphStep::HalfAhead)]);
    }

    void step() {
        steer();
        activeWaves(m_table, m_sea, {static_cast<std::int64_t>(1e6 * (m_time_s + 0.5 * kStep_s))}, *m_waves);
        const WaveEffect effect = m_ship.wavesAt(*m_waves, motion(), 1.0);
        moving = rk4Step(moving, kStep_s, [&](const MovingShip& x) {
            return m_ship.derivative(x, m_actuators, {}, effect, {});
        });
        m_time_s += kStep_s;
    }
    double time_s() const { return m_time_s; }
    const ShipMotion& motion() const { return moving.motion; }
    /// Per unit mass, of what waves stir.
    double energy_m2ps2() const {
        const ShipMotion& m = motion();
        const double kxx = m_vessel.hull.rollGyradius_m, kyy = m_vessel.hull.pitchGyradius_m;
        return 0.5 * (m.sway_mps * m.sway_mps + m.heaveRate_mps * m.heaveRate_mps +
                      std::pow(kxx * m.rollRate_radps, 2) + std::pow(kyy * m.pitchRate_radps, 2) +
                      std::pow(kyy * m.yawRate_radps, 2));
    }
    const Vessel& vessel() const { return m_vessel; }

    MovingShip moving;

private:
    void steer() {
        const int course = static_cast<int>(m_time_s / (kHour_s / kCourses));
        const double off_rad = wrapPi(course * kTwoPi / kCourses - motion().heading_rad);
        const double most = m_vessel.steering.limit_rad;
        m_actuators.rudder_rad = std::clamp(off_rad - 3.0 * motion().yawRate_radps, -most, most);
        if (m_vessel.steering.rudders.empty())
            steerDrives(m_vessel.propulsion, m_actuators.rudder_rad, m_actuators);
    }

    Vessel m_vessel;
    ShipDynamics m_ship;
    WaveTable m_table{7, 200.0};
    SeaState m_sea;
    std::unique_ptr<ActiveWaves> m_waves = std::make_unique<ActiveWaves>();
    Actuators m_actuators;
    double m_time_s = 0.0;
};

Vessel shipped(const std::string& id) {
    return loadVessel(id + ".json", test::readAsset("vessels/" + id + ".json")).value();
}

class HeavySea : public ::testing::TestWithParam<std::string> {};
TEST_P(HeavySea, AnHourOfBeaufort8FromAllSidesLeavesHerFiniteAndHerEnergyBounded) {
    Hour hour(shipped(GetParam()));
    double most[2] = {0.0, 0.0}, roll_rad = 0.0, pitch_rad = 0.0, heave_m = 0.0;
    while (hour.time_s() < kHour_s) {
        hour.step();
        const ShipMotion& m = hour.motion();
        ASSERT_TRUE(std::isfinite(m.north_m + m.east_m + m.down_m + m.roll_rad + m.pitch_rad + m.heading_rad +
                                  m.surge_mps + m.sway_mps + m.yawRate_radps))
            << "at " << hour.time_s() << " s";
        double& most_m2ps2 = most[hour.time_s() < 0.5 * kHour_s ? 0 : 1];
        most_m2ps2 = std::max(most_m2ps2, hour.energy_m2ps2());
        roll_rad = std::max(roll_rad, std::abs(m.roll_rad));
        pitch_rad = std::max(pitch_rad, std::abs(m.pitch_rad));
        heave_m = std::max(heave_m, std::abs(m.down_m));
    }
    RecordProperty("roll_deg", std::to_string(roll_rad / kDegree_rad));
    RecordProperty("pitch_deg", std::to_string(pitch_rad / kDegree_rad));
    RecordProperty("heave_m", std::to_string(heave_m));
    EXPECT_LT(most[1], 4.0 * most[0]);  // the second half has other courses, but no energy of its own
    // Waves of 5.5 m are seldom higher than 11 m and seldom steeper than 20 deg.
    EXPECT_LT(heave_m, 8.0);
    // Boats lie on the slope of waves of their own length, and the rigid inflatable runs them down.
    EXPECT_LT(pitch_rad, (hour.vessel().hull.lengthBp_m > 15.0 ? 30.0 : 80.0) * kDegree_rad);
    EXPECT_LT(roll_rad, 60.0 * kDegree_rad);
}
TEST(HeavySeaAsWetted, TheHullAsSheIsWettedStaysFiniteToo) {
    Vessel vessel = shipped("patrol51");
    vessel.seakeeping.instantaneousHull = true;
    Hour hour(vessel);
    while (hour.time_s() < 0.5 * kHour_s) {
        hour.step();
        const ShipMotion& m = hour.motion();
        ASSERT_LT(std::abs(m.roll_rad) + std::abs(m.pitch_rad), 1.2) << "at " << hour.time_s() << " s";
        ASSERT_LT(std::abs(m.down_m), 8.0) << "at " << hour.time_s() << " s";
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, HeavySea, ::testing::ValuesIn(test::shippedVessels()),
                         [](const auto& row) { return test::testName(row.param); });

}  // namespace
}  // namespace sagara::core
