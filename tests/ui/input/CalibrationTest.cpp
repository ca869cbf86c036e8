#include "ui/input/Calibration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ui/input/TelegraphLever.h"

namespace sagara::ui {
namespace {

TEST(Calibration, EndsAndMiddleOfAWornWheelAreFullAndNought) {
    const AxisCalibration worn{-0.8, 0.1, 0.9, 0.05, false};
    EXPECT_DOUBLE_EQ(calibrated(worn, 0.1), 0.0);
    EXPECT_DOUBLE_EQ(calibrated(worn, 0.9), 1.0);
    EXPECT_DOUBLE_EQ(calibrated(worn, -0.8), -1.0);
    EXPECT_DOUBLE_EQ(calibrated(worn, 1.0), 1.0);   // beyond what was found
    EXPECT_DOUBLE_EQ(calibrated(worn, 0.13), 0.0);  // 0.0375 of the way: in the dead zone
}

TEST(Calibration, InvertedIsTheMirror) {
    AxisCalibration c{-0.8, 0.1, 0.9, 0.05, false};
    for (double raw = -1.0; raw <= 1.0; raw += 0.01) {
        c.inverted = false;
        const double straight = calibrated(c, raw);
        c.inverted = true;
        EXPECT_DOUBLE_EQ(calibrated(c, raw), -straight);
    }
}

TEST(Calibration, RisesWithoutASuddenStep) {
    const AxisCalibration c{-0.9, 0.05, 0.95, 0.1, false};
    double before = calibrated(c, -1.0);
    for (double raw = -1.0; raw <= 1.0; raw += 0.001) {
        const double now = calibrated(c, raw);
        EXPECT_GE(now, before);
        EXPECT_LT(now - before, 0.002);  // 0.001 over the shortest way of 0.9 less a tenth
        before = now;
    }
}

TEST(Calibration, WhatCannotBeUsedIsToldApart) {
    EXPECT_TRUE(usable({}));
    EXPECT_FALSE(usable({0.0, 0.0, 1.0, 0.03, false}));
    EXPECT_FALSE(usable({-1.0, 0.95, 1.0, 0.03, false}));
    EXPECT_FALSE(usable({-1.0, 0.0, 1.0, 0.6, false}));
    EXPECT_FALSE(usable({-1.0, std::nan(""), 1.0, 0.03, false}));
    EXPECT_FALSE(usable({-3.0, 0.0, 1.0, 0.03, false}));
}

TEST(CalibrationRun, FindsMiddleAndEnds) {
    CalibrationRun run({});
    EXPECT_FALSE(run.mayGoOn());  // nothing read yet
    run.feed(0.2);
    run.feed(0.1);
    run.next();
    EXPECT_EQ(run.step(), CalibrationRun::Step::Ends);
    EXPECT_FALSE(run.mayGoOn());
    for (const double raw : {-0.3, -0.7, 0.0, 0.15}) run.feed(raw);
    EXPECT_FALSE(run.mayGoOn());  // not moved to the other end
    run.feed(0.8);
    ASSERT_TRUE(run.mayGoOn());
    run.next();
    EXPECT_EQ(run.step(), CalibrationRun::Step::Done);
    EXPECT_EQ(run.found(), (AxisCalibration{-0.7, 0.1, 0.8, 0.03, false}));
}

TEST(AxisGate, TheFirstReadingIsNoOrder) {
    AxisGate gate;
    EXPECT_FALSE(gate.moved(0.7));
    EXPECT_FALSE(gate.moved(0.7));
    EXPECT_EQ(gate.moved(0.6), 0.6);
}

TEST(AxisGate, FlickerIsHeldBackButTheMiddleIsReached) {
    AxisGate gate;
    gate.moved(0.5);
    EXPECT_FALSE(gate.moved(0.504));
    EXPECT_FALSE(gate.moved(0.497));
    EXPECT_TRUE(gate.moved(0.003));
    EXPECT_EQ(gate.moved(0.0), 0.0);
    EXPECT_TRUE(gate.moved(0.997));
    EXPECT_EQ(gate.moved(1.0), 1.0);
}

TEST(TelegraphLever, EveryStepIsReachedAndLiesWhereItIs) {
    for (std::size_t i = 0; i < core::kTelegraphSteps; ++i) {
        const auto step = static_cast<core::TelegraphStep>(i);
        EXPECT_EQ(nearestStep(leverOf(step)), step);
    }
    EXPECT_EQ(nearestStep(-1.0), core::TelegraphStep::FullAstern);
    EXPECT_EQ(nearestStep(0.0), core::TelegraphStep::Stop);
    EXPECT_EQ(nearestStep(7.0), core::TelegraphStep::FullAhead);
    EXPECT_EQ(stepBy(core::TelegraphStep::FullAhead, 1), core::TelegraphStep::FullAhead);
    EXPECT_EQ(stepBy(core::TelegraphStep::Stop, -1), core::TelegraphStep::DeadSlowAstern);
}

TEST(TelegraphLever, AHandAtTheEdgeRingsOnce) {
    TelegraphLever lever;
    EXPECT_FALSE(lever.moved(0.0));
    int rings = 0;
    // The edge between stop and dead slow ahead is at 0.125.
    for (int i = 0; i < 200; ++i) rings += lever.moved(0.125 + 0.02 * std::sin(i)) ? 1 : 0;
    EXPECT_EQ(rings, 0);
    EXPECT_EQ(lever.moved(0.16), core::TelegraphStep::DeadSlowAhead);
    for (int i = 0; i < 200; ++i) rings += lever.moved(0.125 + 0.02 * std::sin(i)) ? 1 : 0;
    EXPECT_EQ(rings, 0);
    EXPECT_EQ(lever.moved(-1.0), core::TelegraphStep::FullAstern);
}

}  // namespace
}  // namespace sagara::ui
