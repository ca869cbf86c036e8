#include "ui/report/MarkerRows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sagara::report {
namespace {

double halfWidth_mm(const Marker& marker, double widthOfOne_mm) {
    // a range of three numbers and more is printed as two and a dash
    const auto printed = static_cast<double>(std::min<std::size_t>(marker.numbers.size(), 3));
    return 0.5 * widthOfOne_mm * (0.3 + printed);
}

bool collide(const Marker& a, const Marker& b, double widthOfOne_mm) {
    const double needed_mm = halfWidth_mm(a, widthOfOne_mm) + halfWidth_mm(b, widthOfOne_mm);
    return a.row == b.row && std::abs(a.x_mm - b.x_mm) < needed_mm;
}

/// The first row where it is free, else `rows`.
std::size_t freeRow(const std::vector<Marker>& placed, Marker marker, std::size_t rows,
                    double widthOfOne_mm) {
    for (marker.row = 0; marker.row < rows; ++marker.row) {
        const bool taken = std::any_of(placed.begin(), placed.end(), [&](const Marker& other) {
            return collide(other, marker, widthOfOne_mm);
        });
        if (!taken) break;
    }
    return marker.row;
}

/// Adds a number to the last marker, and to it those it now runs into.
void merge(std::vector<Marker>& placed, int number, double widthOfOne_mm) {
    Marker grown = std::move(placed.back());
    placed.pop_back();
    grown.numbers.push_back(number);
    const auto touched = [&](const Marker& other) { return collide(other, grown, widthOfOne_mm); };
    for (auto hit = placed.begin();
         (hit = std::find_if(placed.begin(), placed.end(), touched)) != placed.end();) {
        grown.numbers.insert(grown.numbers.end(), hit->numbers.begin(), hit->numbers.end());
        placed.erase(hit);
    }
    placed.push_back(std::move(grown));
}

}  // namespace

std::vector<Marker> arrangeMarkers(std::span<const double> x_mm, std::size_t rows, double widthOfOne_mm) {
    std::vector<std::size_t> order(x_mm.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return x_mm[a] < x_mm[b]; });
    std::vector<Marker> placed;
    for (const std::size_t i : order) {
        Marker marker{x_mm[i], 0, {static_cast<int>(i) + 1}};
        marker.row = freeRow(placed, marker, rows, widthOfOne_mm);
        if (marker.row < rows) {
            placed.push_back(marker);
        } else {
            merge(placed, marker.numbers.front(), widthOfOne_mm);
        }
    }
    for (Marker& marker : placed) std::sort(marker.numbers.begin(), marker.numbers.end());
    return placed;
}

}  // namespace sagara::report
