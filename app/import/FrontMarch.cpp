#include "app/import/FrontMarch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace sagara::importer {
namespace {

class March {
public:
    March(const Raster& raster, const std::vector<char>& blocked, std::vector<double> ways_m)
        : m_raster(raster), m_blocked(blocked), m_ways_m(std::move(ways_m)), m_final(raster.size(), 0) {}

    std::vector<double> run() {
        for (std::size_t i = 0; i < m_ways_m.size(); ++i) {
            if (m_blocked[i]) m_ways_m[i] = kUnreached_m;
            if (m_ways_m[i] < kUnreached_m) m_front.emplace(m_ways_m[i], i);
        }
        while (!m_front.empty()) {
            const auto [way_m, i] = m_front.top();
            m_front.pop();
            if (m_final[i]) continue;
            m_final[i] = 1;
            widenFrom(i);
        }
        return std::move(m_ways_m);
    }

private:
    void widenFrom(std::size_t i) {
        const std::size_t row = i / m_raster.columns, column = i % m_raster.columns;
        if (row > 0) improve(i - m_raster.columns);
        if (row + 1 < m_raster.rows) improve(i + m_raster.columns);
        if (column > 0) improve(i - 1);
        if (column + 1 < m_raster.columns) improve(i + 1);
    }

    void improve(std::size_t i) {
        if (m_blocked[i] || m_final[i]) return;
        const double way_m = solve(i);
        if (way_m >= m_ways_m[i]) return;
        m_ways_m[i] = way_m;
        m_front.emplace(way_m, i);
    }

    double finalWay_m(std::size_t i) const { return m_final[i] ? m_ways_m[i] : kUnreached_m; }

    /// Godunov's upwind difference from the nearer neighbour on each axis.
    double solve(std::size_t i) const {
        const std::size_t row = i / m_raster.columns, column = i % m_raster.columns;
        double a = kUnreached_m, b = kUnreached_m;
        if (row > 0) a = finalWay_m(i - m_raster.columns);
        if (row + 1 < m_raster.rows) a = std::min(a, finalWay_m(i + m_raster.columns));
        if (column > 0) b = finalWay_m(i - 1);
        if (column + 1 < m_raster.columns) b = std::min(b, finalWay_m(i + 1));
        if (a > b) std::swap(a, b);
        const double h = m_raster.spacing_m;
        if (b - a >= h) return a + h;
        return 0.5 * (a + b + std::sqrt(2.0 * h * h - (b - a) * (b - a)));
    }

    using Entry = std::pair<double, std::size_t>;  ///< the index decides between equal ways, so the order is
                                                   ///< always the same
    const Raster& m_raster;
    const std::vector<char>& m_blocked;
    std::vector<double> m_ways_m;
    std::vector<char> m_final;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> m_front;
};

}  // namespace

std::vector<double> marchFront(const Raster& raster, const std::vector<char>& blocked,
                               std::vector<double> seeds_m) {
    return March(raster, blocked, std::move(seeds_m)).run();
}

}  // namespace sagara::importer
