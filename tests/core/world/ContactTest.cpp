#include "core/world/Contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "FreeBody.h"
#include "SmallAreas.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

using test::FreeBody;

const double kEast = kPi / 2;

FreeBody patrol() { return {54.0, 8.6, 750e3}; }

Load loadIn(const Area& area, const FreeBody& body, NorthEast current = {}) {
    Obstacles found;
    findObstacles(area, body.hull, body.motion, found);
    return contactLoad(found, body.hull, body.motion, current);
}
Touches touchesIn(const Area& area, const FreeBody& body) {
    Obstacles found;
    findObstacles(area, body.hull, body.motion, found);
    return findTouches(found, body.hull, body.motion, {});
}
const Touch& of(const Touches& touches, ContactKind kind) { return touches[static_cast<std::size_t>(kind)]; }

void expectNothing(const Load& load) {
    EXPECT_EQ(load.surge_N, 0.0);
    EXPECT_EQ(load.sway_N, 0.0);
    EXPECT_EQ(load.yaw_Nm, 0.0);
}

// --- a hard quay ---

TEST(HardContact, WithoutTouchThereIsNoLoad) {
    const Area quay = test::longQuay();
    FreeBody body = patrol();
    body.motion = {.north_m = 4.3 + 0.01, .heading_rad = kEast};
    body.setVelocity({-1.0, 0.0});
    expectNothing(loadIn(quay, body));
    for (const Touch& touch : touchesIn(quay, body)) EXPECT_FALSE(touch.touching);
}

TEST(HardContact, FarFromEverythingNothingIsNear) {
    FreeBody body = patrol();
    body.motion.north_m = 500.0;
    Obstacles found;
    findObstacles(test::fenderedQuay(10.0, 250e3), body.hull, body.motion, found);
    EXPECT_TRUE(found.empty());
}

TEST(HardContact, PushesStraightOutWithOneBlowsStiffnessHoweverManyPointsTouch) {
    const Area quay = test::longQuay();
    for (const double length_m : {20.0, 54.0, 343.0}) {
        FreeBody body(length_m, length_m / 6.3, 1e6);
        body.motion = {.north_m = 0.5 * length_m / 6.3 - 0.05, .heading_rad = kEast};  // flat, 5 cm in
        const Load load = loadIn(quay, body);
        EXPECT_NEAR(load.sway_N, -1e6 * 36.0 * 0.05, 1.0) << length_m;  // heading east: north is to port
        EXPECT_NEAR(load.surge_N, 0.0, 1e-3) << length_m;
    }
    FreeBody bow(54.0, 8.6, 1e6);
    bow.motion = {.north_m = 27.0 - 0.05, .heading_rad = kPi};
    EXPECT_NEAR(loadIn(quay, bow).surge_N, -1e6 * 36.0 * 0.05, 1.0);
    EXPECT_NEAR(loadIn(quay, bow).yaw_Nm, 0.0, 1e-3);
}

TEST(HardContact, FrictionActsAgainstSlidingAndIsLessThanItsShareOfTheNormalForce) {
    const Area quay = test::longQuay();
    for (const double slide_mps : {0.0, 0.01, 0.05, 0.5, 5.0, -0.5}) {
        FreeBody body = patrol();
        body.motion = {.north_m = 4.3 - 0.1, .heading_rad = kEast, .surge_mps = slide_mps};
        const Load load = loadIn(quay, body);
        const double normal_N = -load.sway_N, friction_N = -load.surge_N;
        EXPECT_GT(normal_N, 0.0);
        EXPECT_NEAR(friction_N, 0.3 * normal_N * slide_mps / (std::abs(slide_mps) + 0.05), 1e-6 * normal_N)
            << slide_mps;
    }
}

TEST(HardContact, TheMirroredBlowMakesTheMirroredLoad) {
    const Area quay = test::longQuay();
    FreeBody one = patrol(), other = patrol();
    one.motion = {
        .north_m = 10.0, .heading_rad = kPi - 0.6, .surge_mps = 0.5, .sway_mps = 0.2, .yawRate_radps = 0.01};
    other.motion = {.north_m = 10.0,
                    .heading_rad = -kPi + 0.6,
                    .surge_mps = 0.5,
                    .sway_mps = -0.2,
                    .yawRate_radps = -0.01};
    const Load a = loadIn(quay, one), b = loadIn(quay, other);
    ASSERT_NE(a.surge_N, 0.0);
    EXPECT_NEAR(a.surge_N, b.surge_N, 1e-6 * std::abs(a.surge_N));
    EXPECT_NEAR(a.sway_N, -b.sway_N, 1e-6 * std::abs(a.sway_N));
    EXPECT_NEAR(a.yaw_Nm, -b.yaw_Nm, 1e-6 * std::abs(a.yaw_Nm));
}

TEST(HardContact, ACurrentThatCarriesHerOntoTheQuayCountsAsHerSpeed) {
    const Area quay = test::longQuay();
    FreeBody drifting = patrol(), moving = patrol();
    drifting.motion = moving.motion = {.north_m = 4.2, .heading_rad = kEast};
    moving.setVelocity({-0.3, 0.2});
    const Load a = loadIn(quay, drifting, {-0.3, 0.2}), b = loadIn(quay, moving);
    EXPECT_NEAR(a.sway_N, b.sway_N, 1e-6 * std::abs(b.sway_N));
    EXPECT_NEAR(a.surge_N, b.surge_N, 1e-6 * std::abs(b.sway_N));
}

/// Of a box that much off the run of the quay, square to it.
double halfExtent_m(double length_m, double beam_m, double angle_rad) {
    return 0.5 * (length_m * std::abs(std::sin(angle_rad)) + beam_m * std::abs(std::cos(angle_rad)));
}

struct Blow {
    double mass_kg, angle_deg, speed_mps;
};
class BlowOnAQuay : public ::testing::TestWithParam<Blow> {};

TEST_P(BlowOnAQuay, StopsHerWithoutGivingHerEnergy) {
    const Area quay = test::longQuay();
    const double length_m = 54.0 * std::cbrt(GetParam().mass_kg / 360e3), beam_m = length_m / 6.3;
    FreeBody body(length_m, beam_m, GetParam().mass_kg);
    body.motion.heading_rad = kEast + GetParam().angle_deg * kDegree_rad;
    body.motion.north_m = 0.5 + halfExtent_m(length_m, beam_m, GetParam().angle_deg * kDegree_rad);
    body.setVelocity({-GetParam().speed_mps, 0.3 * GetParam().speed_mps});
    const double before_J = body.energy_J();
    double deepest_m = 0.0, lastTouch_s = -1.0, time_s = 0.0;
    while (time_s < lastTouch_s + 10.0 || lastTouch_s < 0.0) {
        body.tick(quay);
        time_s += kTick_s;
        const double in_m = body.southOf_m(0.0);
        if (in_m > 0.0) lastTouch_s = time_s;
        deepest_m = std::max(deepest_m, in_m);
        // While it is pressed in the spring holds part of it; no tick may end with more than she brought
        // along.
        ASSERT_LE(body.energy_J(), before_J * (1.0 + 1e-9)) << time_s;
        ASSERT_LT(time_s, 1000.0);
    }
    EXPECT_LT(body.energy_J(), 0.9 * before_J);
    EXPECT_LT(deepest_m, GetParam().speed_mps / 6.0);  // v / omega: what the undamped spring would give
}

std::vector<Blow> blows() {
    std::vector<Blow> all;
    for (const double mass_kg : {1e5, 7.5e5, 1e7, 3e8}) {
        for (const double angle_deg : {0.0, 2.0, 30.0, 90.0, 135.0, 180.0}) {
            for (const double speed_mps : {0.2, 1.0, 4.0}) all.push_back({mass_kg, angle_deg, speed_mps});
        }
    }
    return all;
}
INSTANTIATE_TEST_SUITE_P(OfEveryMass, BlowOnAQuay, ::testing::ValuesIn(blows()), [](const auto& row) {
    return std::to_string(std::lround(row.param.mass_kg / 1000.0)) + "tAt" +
           std::to_string(std::lround(row.param.angle_deg)) + "deg" +
           std::to_string(std::lround(100.0 * row.param.speed_mps)) + "cmps";
});

TEST(HardContact, PressedOnShePressesBackAndLies) {
    const Area quay = test::longQuay();
    for (const double mass_kg : {750e3, 3e8}) {
        const double length_m = 54.0 * std::cbrt(mass_kg / 360e3);
        FreeBody body(length_m, length_m / 6.3, mass_kg);
        const double angle_rad = 0.5 * kDegree_rad;
        body.motion = {.north_m = 0.1 + halfExtent_m(length_m, length_m / 6.3, angle_rad),
                       .heading_rad = kEast + angle_rad};
        Obstacles found;
        for (int i = 0; i < 120 * kTicksPerSecond; ++i) {
            found = {};
            findObstacles(quay, body.hull, body.motion, found);
            body.motion.sway_mps += 0.05 * kTick_s;  // to starboard, which is south: wind of a steady gale
            body.tick(found);
        }
        EXPECT_NEAR(body.southOf_m(0.0), 0.05 / 36.0, 0.05 / 36.0)
            << mass_kg;  // g / omega^2, flat or on an end
        EXPECT_LT(length(body.velocity()), 0.01) << mass_kg;
    }
}

// --- corners ---

TEST(CornerContact, TheHeadOfANarrowJettyStopsTheSideOfAHull) {
    // 1 m wide: it passes between the points of the outline, which are up to 3 m apart
    for (const double east_m : {-20.0, -11.3, 0.0, 1.4, 9.1}) {
        const Area area = test::withLand(
            {{{0.0, east_m - 0.5}, {0.0, east_m + 0.5}, {-60.0, east_m + 0.5}, {-60.0, east_m - 0.5}}},
            ShoreKind::Jetty);
        FreeBody body = patrol();
        body.motion = {.north_m = 4.3 + 0.2, .heading_rad = kEast};
        body.setVelocity({-0.5, 0.0});
        const double before_J = body.energy_J();
        double deepest_m = 0.0;
        for (int i = 0; i < 10 * kTicksPerSecond; ++i) {
            body.tick(area);
            ASSERT_LE(body.energy_J(), before_J * (1.0 + 1e-9));
            deepest_m = std::max(deepest_m, 4.3 - body.frame().pointInBody({0.0, east_m}).y_m);
        }
        EXPECT_LT(deepest_m, 0.5 / 6.0) << east_m;
        EXPECT_GT(body.frame().pointInBody({0.0, east_m}).y_m, 4.3) << east_m;  // she has come off it
    }
}

TEST(CornerContact, InTheCornerOfTwoQuaysSheIsStoppedBothWays) {
    const Area area = test::withLand({{{500.0, 0.0},
                                       {0.0, 0.0},
                                       {0.0, -500.0},
                                       {-100.0, -500.0},
                                       {-100.0, 100.0},
                                       {500.0, 100.0}}});  // water NW of it
    FreeBody body = patrol();
    body.motion = {.north_m = 6.0, .east_m = -29.0, .heading_rad = kEast};
    body.setVelocity({-0.4, 0.6});
    const double before_J = body.energy_J();
    for (int i = 0; i < 30 * kTicksPerSecond; ++i) {
        body.tick(area);
        ASSERT_LE(body.energy_J(), before_J * (1.0 + 1e-9));
        ASSERT_LT(body.southOf_m(0.0), 0.2);
        ASSERT_LT(body.frame().point({27.0, 0.0}).east_m, 0.2);
    }
}

// --- what is reported ---

TEST(Touches, NameTheKindOfShore) {
    const struct {
        ShoreKind shore;
        ContactKind contact;
    } cases[] = {{ShoreKind::Quay, ContactKind::Quay},   {ShoreKind::Jetty, ContactKind::Quay},
                 {ShoreKind::Rock, ContactKind::Shore},  {ShoreKind::Breakwater, ContactKind::Breakwater},
                 {ShoreKind::Beach, ContactKind::Shore}, {ShoreKind::Other, ContactKind::Shore}};
    for (const auto& c : cases) {
        FreeBody body = patrol();
        body.motion = {.north_m = 4.2, .heading_rad = kEast};
        const Touches touches = touchesIn(test::longQuay(c.shore), body);
        for (std::size_t kind = 0; kind < kContactKinds; ++kind) {
            EXPECT_EQ(touches[kind].touching, kind == static_cast<std::size_t>(c.contact));
        }
    }
}

TEST(Touches, EnergyOfABroadsideBlowIsAllOfIt) {
    FreeBody body(54.0, 8.6, 750e3);
    // only the point amidships: a pile
    const Area pile = test::withLand({{{0.0, -0.5}, {0.0, 0.5}, {-9.0, 0.5}, {-9.0, -0.5}}});
    body.motion = {.north_m = 4.25, .heading_rad = kEast};
    body.setVelocity({-0.4, 0.0});
    const Touch touch = of(touchesIn(pile, body), ContactKind::Quay);
    ASSERT_TRUE(touch.touching);
    EXPECT_NEAR(touch.approach_mps, 0.4, 1e-12);
    EXPECT_NEAR(touch.energy_J, 0.5 * 750e3 * 0.16, 0.002 * touch.energy_J);  // half a metre off the middle
    EXPECT_NEAR(touch.place.north_m, -0.05, 0.06);
}

TEST(Touches, ABlowOffTheMiddleTurnsHerInsteadOfStoppingHer) {
    // share k^2 / (k^2 + x^2), k = L / 4: a half at a quarter of the length
    const Area pile = test::withLand({{{0.0, -14.0}, {0.0, -13.0}, {-9.0, -13.0}, {-9.0, -14.0}}});
    FreeBody body(54.0, 8.6, 750e3);
    body.motion = {.north_m = 4.25, .heading_rad = kEast};
    body.setVelocity({-0.4, 0.0});
    const Touch touch = of(touchesIn(pile, body), ContactKind::Quay);
    ASSERT_TRUE(touch.touching);
    EXPECT_NEAR(touch.energy_J, 0.5 * 0.5 * 750e3 * 0.16,
                0.05 * touch.energy_J);  // the corners are half a metre either side
}

TEST(Touches, ABlowOnTheStemStopsHerAltogether) {
    FreeBody body(54.0, 8.6, 750e3);
    body.motion = {.north_m = 26.95, .heading_rad = kPi, .surge_mps = 0.5};
    const Touch touch = of(touchesIn(test::longQuay(), body), ContactKind::Quay);
    ASSERT_TRUE(touch.touching);
    EXPECT_NEAR(touch.approach_mps, 0.5, 1e-12);
    EXPECT_NEAR(touch.energy_J, 0.5 * 750e3 * 0.25, 1e-6 * touch.energy_J);
}

TEST(Touches, AHeadOnBlowHasNoAddedMassOfSway) {
    Hull form;
    form.lengthOverall_m = 54.0;
    form.beam_m = 8.6;
    form.displacement_m3 = 357.0;
    form.waterDensity_kgpm3 = 1014.0;
    FreeBody body = patrol();
    body.hull = contactHull(form, 755e3);
    body.motion = {.north_m = 26.95, .heading_rad = kPi, .surge_mps = 0.5};
    EXPECT_NEAR(of(touchesIn(test::longQuay(), body), ContactKind::Quay).energy_J,
                0.5 * 357.0 * 1014.0 * 0.25, 1.0);
}

TEST(Touches, PartingHasNoEnergy) {
    FreeBody body = patrol();
    body.motion = {.north_m = 4.2, .heading_rad = kEast};
    body.setVelocity({0.4, 0.0});
    const Touch touch = of(touchesIn(test::longQuay(), body), ContactKind::Quay);
    EXPECT_TRUE(touch.touching);
    EXPECT_NEAR(touch.approach_mps, -0.4, 1e-12);
    EXPECT_EQ(touch.energy_J, 0.0);
}

TEST(Touches, EnergyReportedIsWhatTheObstacleTakesUp) {
    // When the point stands still against the pile, what is left is her turning and the rest of her way.
    const Area pile = test::withLand({{{0.0, -14.0}, {0.0, -13.0}, {-9.0, -13.0}, {-9.0, -14.0}}});
    FreeBody body(54.0, 8.6, 750e3);
    body.motion = {.north_m = 4.3 - 1e-6, .heading_rad = kEast};
    body.setVelocity({-0.3, 0.0});
    const Touch blow = of(touchesIn(pile, body), ContactKind::Quay);
    const double before_J = body.energy_J();
    while (of(touchesIn(pile, body), ContactKind::Quay).approach_mps > 0.0) body.tick(pile);
    // friction at the side, 4 m off the centreline, hinders the turn: a few per cent more goes into the pile
    EXPECT_NEAR(before_J - body.energy_J(), blow.energy_J, 0.1 * blow.energy_J);
}

}  // namespace
}  // namespace sagara::core
