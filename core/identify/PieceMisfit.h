#pragma once

#include "core/identify/LeastSquares.h"

namespace sagara::core {

/// One piece of a fit in terms of z, its unknowns as priors from their start: weighted misfit and its
/// derivatives by central differences of a hundredth of a prior.
class PieceMisfit {
public:
    /// Both outlive it.
    PieceMisfit(const FitProblem& problem, const FitPiece& piece) : m_problem(problem), m_piece(piece) {}

    using Blocks = std::vector<std::vector<double>>;  ///< shared and own; one that has none is left out
    bool at(const Blocks& z, std::vector<double>& out) const;
    /// Row-major, a row for each measurement, by the unknowns of block `b`; `here` is the misfit at z. A side
    /// on which the model leaves the numbers is left out.
    void differentiate(Blocks z, std::size_t b, const std::vector<double>& here, double* jacobian) const;

private:
    const FitProblem& m_problem;
    const FitPiece& m_piece;
};

/// z in the units of the unknowns, within their bounds.
std::vector<double> inUnits(const std::vector<Unknown>& unknowns, const double* z);

}  // namespace sagara::core
