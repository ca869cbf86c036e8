#pragma once

#include <span>
#include <vector>

namespace sagara::report {

/// Numbers along a line that stand in several rows where they are dense, and together ("4, 5") where even
/// that is too little.
struct Marker {
    double x_mm = 0.0;
    std::size_t row = 0;
    std::vector<int> numbers;
};

/// The i-th number, counted from 1, belongs at x_mm[i].
std::vector<Marker> arrangeMarkers(std::span<const double> x_mm, std::size_t rows, double widthOfOne_mm);

}  // namespace sagara::report
