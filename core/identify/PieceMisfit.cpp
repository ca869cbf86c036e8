#include "core/identify/PieceMisfit.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {
namespace {

constexpr double kDifference = 0.01;  ///< of a prior
constexpr double kOutlier = 5.0;      ///< standard deviations

/// Half its square is the pseudo-Huber loss of Charbonnier et al. (1997), IEEE Trans. Image Processing 6(2).
double softened(double misfit) {
    const double share = misfit / kOutlier;
    return std::copysign(kOutlier * std::sqrt(2.0 * share * share / (std::sqrt(1.0 + share * share) + 1.0)),
                         misfit);
}

bool finite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

std::vector<double> inUnits(const std::vector<Unknown>& unknowns, const double* z) {
    std::vector<double> x(unknowns.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Unknown& u = unknowns[i];
        x[i] = std::clamp(u.start + u.prior * z[i], u.low, u.high);
    }
    return x;
}

bool PieceMisfit::at(const Blocks& z, std::vector<double>& out) const {
    const auto shared = inUnits(m_problem.shared, m_problem.shared.empty() ? nullptr : z.front().data());
    const auto own = inUnits(m_piece.own, m_piece.own.empty() ? nullptr : z.back().data());
    if (!m_piece.misfit(shared, own, out) || !finite(out)) return false;
    const double weight = std::sqrt(m_piece.independent / static_cast<double>(m_piece.measurements));
    for (double& value : out) value = weight * softened(value);
    return true;
}

void PieceMisfit::differentiate(Blocks z, std::size_t b, const std::vector<double>& here,
                                double* jacobian) const {
    const std::size_t unknowns = z[b].size();
    for (std::size_t i = 0; i < unknowns; ++i) {
        const double middle = z[b][i];
        std::vector<double> up(here.size()), down(here.size());
        z[b][i] = middle + kDifference;
        const bool above = at(z, up);
        z[b][i] = middle - kDifference;
        const bool below = at(z, down);
        z[b][i] = middle;
        if (!above) up = here;
        if (!below) down = here;
        const double width = kDifference * ((above ? 1.0 : 0.0) + (below ? 1.0 : 0.0));
        for (std::size_t m = 0; m < here.size(); ++m)
            jacobian[m * unknowns + i] = width > 0.0 ? (up[m] - down[m]) / width : 0.0;
    }
}

}  // namespace sagara::core
