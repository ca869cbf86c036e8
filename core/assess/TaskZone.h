#pragma once

#include <vector>

#include "core/base/Planar.h"

namespace sagara::core {

/// Where something is to be done, for charts. Frame N.
struct TaskZone {
    enum class Kind { Circle, Gate, Polygon };
    Kind kind = Kind::Circle;
    std::vector<NorthEast> points;  ///< the centre; the two ends; or the corners
    double radius_m = 0.0;          ///< of a circle

    static TaskZone circle(NorthEast centre, double radius_m) { return {Kind::Circle, {centre}, radius_m}; }
    static TaskZone gate(NorthEast a, NorthEast b) { return {Kind::Gate, {a, b}, 0.0}; }
    static TaskZone polygon(std::vector<NorthEast> corners) {
        return {Kind::Polygon, std::move(corners), 0.0};
    }
};

}  // namespace sagara::core
