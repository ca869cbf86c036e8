#pragma once

#include <span>
#include <vector>

namespace sagara::report {

/// Range of an axis and where its ticks are: multiples of `step` from `low` to `high`.
struct Axis {
    double low = 0.0;
    double high = 1.0;
    double step = 1.0;

    std::vector<double> ticks() const;
};

/// What an axis of a quantity must show besides the values.
struct AxisRule {
    double least = 0.0;         ///< the axis reaches at least down to this ...
    double most = 0.0;          ///< ... and up to this
    bool symmetric = false;     ///< as far below zero as above
    int tickCount = 4;          ///< about so many steps
    std::vector<double> steps;  ///< allowed; empty: 1, 2, 5 and their tenfolds
};

/// Values that are not finite are passed over. Low and high are ticks.
Axis axisFor(std::span<const double> values, const AxisRule& rule);

/// Full minutes, or halves of one in short runs, for a time axis in seconds from 0.
double timeStep_s(double end_s);

}  // namespace sagara::report
