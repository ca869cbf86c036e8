#include "ui/report/MarkerRows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sagara::report {
namespace {

using WidthOf = std::function<double(const std::vector<int>&)>;

bool collide(const Marker& a, const Marker& b, const WidthOf& widthOf) {
    return a.row == b.row && std::abs(a.x_mm - b.x_mm) < 0.5 * (widthOf(a.numbers) + widthOf(b.numbers));
}

/// The first row where it is free, else `rows`.
std::size_t freeRow(const std::vector<Marker>& placed, Marker marker, std::size_t rows,
                    const WidthOf& widthOf) {
    for (marker.row = 0; marker.row < rows; ++marker.row) {
        const bool taken = std::any_of(placed.begin(), placed.end(),
                                       [&](const Marker& other) { return collide(other, marker, widthOf); });
        if (!taken) break;
    }
    return marker.row;
}

void join(Marker& marker, const std::vector<int>& numbers) {
    marker.numbers.insert(marker.numbers.end(), numbers.begin(), numbers.end());
    std::sort(marker.numbers.begin(), marker.numbers.end());
}

/// Adds a number to the last marker, and to it those it now runs into.
void merge(std::vector<Marker>& placed, int number, const WidthOf& widthOf) {
    Marker grown = std::move(placed.back());
    placed.pop_back();
    join(grown, {number});
    const auto touched = [&](const Marker& other) { return collide(other, grown, widthOf); };
    for (auto hit = placed.begin();
         (hit = std::find_if(placed.begin(), placed.end(), touched)) != placed.end();) {
        join(grown, hit->numbers);
        placed.erase(hit);
    }
    placed.push_back(std::move(grown));
}

}  // namespace

std::vector<Marker> arrangeMarkers(std::span<const double> x_mm, std::size_t rows, const WidthOf& widthOf) {
    std::vector<std::size_t> order(x_mm.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return x_mm[a] < x_mm[b]; });
    std::vector<Marker> placed;
    for (const std::size_t i : order) {
        Marker marker{x_mm[i], 0, {static_cast<int>(i) + 1}};
        marker.row = freeRow(placed, marker, rows, widthOf);
        if (marker.row < rows) {
            placed.push_back(std::move(marker));
        } else {
            merge(placed, marker.numbers.front(), widthOf);
        }
    }
    return placed;
}

}  // namespace sagara::report
