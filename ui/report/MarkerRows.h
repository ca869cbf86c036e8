#pragma once

#include <functional>
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

/// The i-th number, counted from 1, belongs at x_mm[i]. `widthOf` measures numbers that stand together; no
/// two markers of a row overlap unless they all stand at one place.
std::vector<Marker> arrangeMarkers(std::span<const double> x_mm, std::size_t rows,
                                   const std::function<double(const std::vector<int>&)>& widthOf);

}  // namespace sagara::report
