#pragma once

#include "core/identify/ReplayShip.h"

namespace sagara::core {

/// What is not exactly known of the beginning of a record: added to what its first row says.
struct TrialStart {
    double rudder_rad = 0.0;  ///< throughout: the angle at which her rudders are not felt is not quite zero
    double surge_mps = 0.0;
    double sway_mps = 0.0;
    double yawRate_radps = 0.0;
    double heading_rad = 0.0;
};

/// Lengths per time that a trial is measured in: a number per length run is independent of the last.
double lengthTime_s(const SeaTrial& trial, double length_m);
/// Speed before the order: of the header, else the first of the record, 0 for a decay without either.
double approachOf_mps(const SeaTrial& trial);
/// That of the header, else what holds the approach speed.
double steadyShaft_rps(const ReplayShip& ship, const SeaTrial& trial);

/// The ship's motion at the rows of a trial (turning, zigzag, stopping, decay), driven by the recorded rudder
/// and shaft. Without a rudder column she turns it herself, at her gear's rate, as the trial's kind asks;
/// without a shaft it is what holds the approach speed. Empty: she left the numbers.
std::vector<ShipMotion> replay(ReplayShip& ship, const SeaTrial& trial, const TrialStart& start);

}  // namespace sagara::core
