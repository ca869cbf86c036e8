#include "core/identify/FitCurvature.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace sagara::core {
namespace {

/// Curvature of half the sum of squares at the answer, in priors: of the shared unknowns, what the own ones
/// can take over taken off (Schur's complement).
class Curvature {
public:
    Curvature(const FitProblem& problem, const std::vector<PieceMisfit::Blocks>& z) {
        const auto n = static_cast<Eigen::Index>(problem.shared.size());
        m_shared = Eigen::MatrixXd::Zero(n, n);
        for (std::size_t p = 0; p < problem.pieces.size(); ++p) add(problem, problem.pieces[p], z[p]);
    }
    const Eigen::MatrixXd& shared() const { return m_shared; }
    double meanSquare() const { return m_independent > 0.0 ? m_squares / m_independent : 0.0; }

private:
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    void add(const FitProblem& problem, const FitPiece& piece, const PieceMisfit::Blocks& z) {
        const PieceMisfit misfit(problem, piece);
        std::vector<double> here(piece.measurements);
        if (here.empty() || !misfit.at(z, here)) return;
        for (const double value : here) m_squares += value * value;
        m_independent += piece.independent;
        const Eigen::Index n = m_shared.rows(), k = static_cast<Eigen::Index>(piece.own.size());
        if (n == 0) return;
        const auto rows = static_cast<Eigen::Index>(here.size());
        RowMajor shared(rows, n), own(rows, k);
        misfit.differentiate(z, 0, here, shared.data());
        m_shared += shared.transpose() * shared;
        if (k == 0) return;
        misfit.differentiate(z, 1, here, own.data());
        const Eigen::MatrixXd curvature = own.transpose() * own + Eigen::MatrixXd::Identity(k, k),
                              cross = own.transpose() * shared;
        m_shared -= cross.transpose() * curvature.ldlt().solve(cross);
    }

    Eigen::MatrixXd m_shared;
    double m_squares = 0.0, m_independent = 0.0;
};

}  // namespace

void judge(FitAnswer& answer, const FitProblem& problem, const std::vector<PieceMisfit::Blocks>& z) {
    const Curvature curvature(problem, z);
    answer.meanSquare = curvature.meanSquare();
    const Eigen::Index n = curvature.shared().rows();
    if (n == 0) return;
    // A misfit beyond what was to be expected tells less.
    const Eigen::MatrixXd told = curvature.shared() / std::max(1.0, answer.meanSquare);
    const Eigen::MatrixXd spread = (told + Eigen::MatrixXd::Identity(n, n)).inverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> directions(told);
    const auto prior = [&](Eigen::Index i) { return problem.shared[static_cast<std::size_t>(i)].prior; };
    for (Eigen::Index i = 0; i < n; ++i) {
        answer.sharpness.push_back(std::sqrt(std::max(0.0, directions.eigenvalues()[n - 1 - i])));
        for (Eigen::Index j = 0; j < n; ++j) answer.covariance.push_back(spread(i, j) * prior(i) * prior(j));
        answer.deviation.push_back(std::sqrt(std::max(0.0, spread(i, i))) * prior(i));
    }
}

}  // namespace sagara::core
