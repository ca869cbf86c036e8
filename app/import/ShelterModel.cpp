#include "app/import/ShelterModel.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "app/import/FrontMarch.h"
#include "core/base/Units.h"

namespace sagara::importer {
namespace {

using core::NorthEast;

/// One raster with what blocks waves on it and the energy that arrived so far.
struct Sheet {
    const Raster* raster;
    std::vector<char> blocked;
    std::vector<double> energy;
};

/// Land, and nodes so near to the shoreline that a front could slip between two of them through a thin wall.
std::vector<char> blockedNodes(const Raster& raster, const LocalCoast& coast) {
    std::vector<char> blocked = nodesInside(raster, coast.land);
    const double half_m = 0.5 * raster.spacing_m;
    for (std::size_t i = 0; i < blocked.size(); ++i) {
        if (coast.shore.distance_m(raster.node(i), half_m) < half_m) blocked[i] = 1;
    }
    return blocked;
}

/// Share of each direction, by where the waves come from in degrees. The sum is 1.
std::map<double, double> shares(const ShelterRules& rules) {
    std::map<double, double> all;
    double sum = 0.0;
    for (const auto& sector : rules.sectors) {
        const int steps =
            std::max(0, static_cast<int>(std::round((sector.to_deg - sector.from_deg) / rules.step_deg)));
        for (int i = 0; i <= steps; ++i)
            all[sector.from_deg + i * rules.step_deg] += sector.share / (steps + 1);
        sum += sector.share;
    }
    for (auto& [from_deg, share] : all) share /= sum;
    return all;
}

/// No detour yet at the sides over which the wave comes in.
std::vector<double> seedsOffshore(const Raster& raster, NorthEast along) {
    std::vector<double> ways_m(raster.size(), kUnreached_m);
    const auto seed = [&](std::size_t row, std::size_t column) {
        ways_m[row * raster.columns + column] = dot(raster.node(row, column), along);
    };
    for (std::size_t column = 0; column < raster.columns; ++column) {
        if (along.north_m > 0.0) seed(0, column);
        if (along.north_m < 0.0) seed(raster.rows - 1, column);
    }
    for (std::size_t row = 0; row < raster.rows; ++row) {
        if (along.east_m > 0.0) seed(row, 0);
        if (along.east_m < 0.0) seed(row, raster.columns - 1);
    }
    return ways_m;
}

/// Bilinear; unreached as soon as one of the four nodes is.
double detourAt(const Raster& raster, const std::vector<double>& detours_m, NorthEast p) {
    const NorthEast at = (1.0 / raster.spacing_m) * (p - raster.southWest);
    const auto row = std::min(static_cast<std::size_t>(std::max(at.north_m, 0.0)), raster.rows - 2);
    const auto column = std::min(static_cast<std::size_t>(std::max(at.east_m, 0.0)), raster.columns - 2);
    const double* d = detours_m.data() + row * raster.columns + column;
    const double* e = d + raster.columns;
    if (std::max({d[0], d[1], e[0], e[1]}) == kUnreached_m) return kUnreached_m;
    const double v = at.north_m - static_cast<double>(row), u = at.east_m - static_cast<double>(column);
    return (1.0 - v) * ((1.0 - u) * d[0] + u * d[1]) + v * ((1.0 - u) * e[0] + u * e[1]);
}

/// Along the sides of an inner raster the wave has come the way the outer one says.
std::vector<double> seedsWithin(const Raster& inner, const Raster& outer,
                                const std::vector<double>& detours_m, NorthEast along) {
    std::vector<double> ways_m(inner.size(), kUnreached_m);
    for (std::size_t i = 0; i < ways_m.size(); ++i) {
        const std::size_t row = i / inner.columns, column = i % inner.columns;
        if (row > 0 && row + 1 < inner.rows && column > 0 && column + 1 < inner.columns) continue;
        const NorthEast p = inner.node(i);
        ways_m[i] = detourAt(outer, detours_m, p) + dot(p, along);
    }
    return ways_m;
}

std::vector<double> detours(const Sheet& sheet, std::vector<double> seeds_m, NorthEast along) {
    std::vector<double> ways_m = marchFront(*sheet.raster, sheet.blocked, std::move(seeds_m));
    for (std::size_t i = 0; i < ways_m.size(); ++i) ways_m[i] -= dot(sheet.raster->node(i), along);
    return ways_m;
}

void addDirection(std::vector<Sheet>& sheets, double from_deg, double share, double waveLength_m) {
    const NorthEast along = -1.0 * core::unitVector(from_deg * core::kDegree_rad);
    std::vector<double> outer;
    for (std::size_t s = sheets.size(); s-- > 0;) {
        const bool outermost = s + 1 == sheets.size();
        Sheet& sheet = sheets[s];
        outer = detours(sheet,
                        outermost ? seedsOffshore(*sheet.raster, along)
                                  : seedsWithin(*sheet.raster, *sheets[s + 1].raster, outer, along),
                        along);
        for (std::size_t i = 0; i < outer.size(); ++i)
            sheet.energy[i] += share * arrivingEnergy(outer[i], waveLength_m);
    }
}

/// Mean of the known nodes round one; negative when there are none.
double meanAround(const Raster& raster, const std::vector<char>& unknown, const std::vector<double>& factors,
                  std::size_t i) {
    const std::size_t row = i / raster.columns, column = i % raster.columns;
    double sum = 0.0;
    int count = 0;
    for (std::size_t r = row - std::min<std::size_t>(row, 1); r < std::min(row + 2, raster.rows); ++r) {
        for (std::size_t c = column - std::min<std::size_t>(column, 1);
             c < std::min(column + 2, raster.columns); ++c) {
            if (unknown[r * raster.columns + c]) continue;
            sum += factors[r * raster.columns + c];
            ++count;
        }
    }
    return count ? sum / count : -1.0;
}

/// Carries the factors one node into what is unknown.
void carryOn(const Raster& raster, std::vector<char>& unknown, std::vector<double>& factors) {
    const std::vector<char> before = unknown;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const double mean = before[i] ? meanAround(raster, before, factors, i) : -1.0;
        if (mean < 0.0) continue;
        factors[i] = mean;
        unknown[i] = 0;
    }
}

/// Two nodes into the land have the water's factor, so that right at a quay it is not mixed with the land's
/// 0.
std::vector<double> factorsOf(const Sheet& sheet) {
    std::vector<double> factors(sheet.energy.size());
    for (std::size_t i = 0; i < factors.size(); ++i) factors[i] = std::min(1.0, std::sqrt(sheet.energy[i]));
    std::vector<char> unknown = sheet.blocked;
    carryOn(*sheet.raster, unknown, factors);
    carryOn(*sheet.raster, unknown, factors);
    return factors;
}

}  // namespace

double arrivingEnergy(double detour_m, double waveLength_m) {
    return 1.0 / (1.0 + 8.0 * core::kPi * core::kPi * std::max(0.0, detour_m) / waveLength_m);
}

std::vector<std::vector<double>> modelShelter(const ShelterRules& rules, const std::vector<Raster>& rasters,
                                              const LocalCoast& coast) {
    std::vector<Sheet> sheets;
    for (const Raster& r : rasters)
        sheets.push_back({&r, blockedNodes(r, coast), std::vector<double>(r.size(), 0.0)});
    for (const auto& [from_deg, share] : shares(rules))
        addDirection(sheets, from_deg, share, rules.waveLength_m);
    std::vector<std::vector<double>> factors;
    for (const Sheet& sheet : sheets) factors.push_back(factorsOf(sheet));
    return factors;
}

}  // namespace sagara::importer
