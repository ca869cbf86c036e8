#include "core/identify/LeastSquares.h"

#include <ceres/ceres.h>

#include <Eigen/Dense>
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

double inUnits(const Unknown& u, double z) { return std::clamp(u.start + u.prior * z, u.low, u.high); }
std::vector<double> inUnits(const std::vector<Unknown>& unknowns, const double* z) {
    std::vector<double> x(unknowns.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = inUnits(unknowns[i], z[i]);
    return x;
}

bool finite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// One piece as Ceres sees it: unknowns as priors from their start. Blocks: shared, own.
class PieceCost final : public ceres::CostFunction {
public:
    PieceCost(const FitProblem& problem, const FitPiece& piece) : m_problem(problem), m_piece(piece) {
        set_num_residuals(static_cast<int>(piece.measurements));
        for (const auto* block : {&problem.shared, &piece.own})
            if (!block->empty()) mutable_parameter_block_sizes()->push_back(static_cast<int>(block->size()));
    }

    bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override {
        std::vector<std::vector<double>> z;
        for (std::size_t b = 0; b < parameter_block_sizes().size(); ++b)
            z.emplace_back(blocks[b], blocks[b] + parameter_block_sizes()[b]);
        std::vector<double> here(m_piece.measurements);
        if (!misfit(z, here)) return false;
        std::copy(here.begin(), here.end(), residuals);
        for (std::size_t b = 0; jacobians && b < z.size(); ++b)
            if (jacobians[b])
                for (std::size_t i = 0; i < z[b].size(); ++i) differentiate(z, b, i, here, jacobians[b]);
        return true;
    }

private:
    bool misfit(const std::vector<std::vector<double>>& z, std::vector<double>& out) const {
        static const std::vector<double> none;
        const bool shares = !m_problem.shared.empty();
        const auto shared = inUnits(m_problem.shared, shares ? z.front().data() : nullptr);
        const auto own = inUnits(m_piece.own, m_piece.own.empty() ? nullptr : z.back().data());
        if (!m_piece.misfit(shared, own, out) || !finite(out)) return false;
        const double weight = std::sqrt(m_piece.independent / static_cast<double>(m_piece.measurements));
        for (double& value : out) value = weight * softened(value);
        return true;
    }

    /// A side on which the model leaves the numbers is left out.
    void differentiate(std::vector<std::vector<double>>& z, std::size_t b, std::size_t i,
                       const std::vector<double>& here, double* jacobian) const {
        const double at = z[b][i];
        std::vector<double> up(here.size()), down(here.size());
        z[b][i] = at + kDifference;
        const bool above = misfit(z, up);
        z[b][i] = at - kDifference;
        const bool below = misfit(z, down);
        z[b][i] = at;
        if (!above) up = here;
        if (!below) down = here;
        const double width = kDifference * ((above ? 1.0 : 0.0) + (below ? 1.0 : 0.0));
        for (std::size_t m = 0; m < here.size(); ++m)
            jacobian[m * z[b].size() + i] = width > 0.0 ? (up[m] - down[m]) / width : 0.0;
    }

    const FitProblem& m_problem;
    const FitPiece& m_piece;
};

/// What was believed beforehand: the unknowns themselves.
class PriorCost final : public ceres::CostFunction {
public:
    explicit PriorCost(std::size_t count) : m_count(count) {
        set_num_residuals(static_cast<int>(count));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(count));
    }
    bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override {
        std::copy(blocks[0], blocks[0] + m_count, residuals);
        for (std::size_t i = 0; jacobians && jacobians[0] && i < m_count * m_count; ++i)
            jacobians[0][i] = i % (m_count + 1) == 0 ? 1.0 : 0.0;
        return true;
    }

private:
    std::size_t m_count;
};

class Watch final : public ceres::IterationCallback {
public:
    explicit Watch(const FitProblem& problem) : m_problem(problem) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary& now) override {
        const bool on = !m_problem.watch || m_problem.watch(now.iteration);
        return on ? ceres::SOLVER_CONTINUE : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
    }

private:
    const FitProblem& m_problem;
};

/// The unknowns in Ceres' hands.
struct Blocks {
    std::vector<double> shared;
    std::vector<std::vector<double>> own;

    explicit Blocks(const FitProblem& problem) : shared(problem.shared.size(), 0.0) {
        for (const FitPiece& piece : problem.pieces) own.emplace_back(piece.own.size(), 0.0);
    }
    std::vector<double*> of(std::size_t piece) {
        std::vector<double*> blocks;
        if (!shared.empty()) blocks.push_back(shared.data());
        if (!own[piece].empty()) blocks.push_back(own[piece].data());
        return blocks;
    }
};

void bound(ceres::Problem& problem, const std::vector<Unknown>& unknowns, std::vector<double>& z) {
    if (z.empty()) return;
    problem.AddParameterBlock(z.data(), static_cast<int>(z.size()));
    for (std::size_t i = 0; i < z.size(); ++i) {
        const Unknown& u = unknowns[i];
        problem.SetParameterLowerBound(z.data(), static_cast<int>(i), (u.low - u.start) / u.prior);
        problem.SetParameterUpperBound(z.data(), static_cast<int>(i), (u.high - u.start) / u.prior);
    }
    problem.AddResidualBlock(new PriorCost(z.size()), nullptr, z.data());
}

ceres::Solver::Options options(Watch& watch) {
    ceres::Solver::Options o;
    o.linear_solver_type = ceres::DENSE_QR;
    o.max_num_iterations = 60;
    o.function_tolerance = 1e-5;
    o.parameter_tolerance = 1e-6;
    o.logging_type = ceres::SILENT;
    o.callbacks = {&watch};
    return o;
}

/// Curvature of half the sum of squares at the answer, in priors: of the shared unknowns, what the own ones
/// can take over taken off (Schur's complement).
class Curvature {
public:
    Curvature(const FitProblem& problem, Blocks& z) {
        const auto n = static_cast<Eigen::Index>(problem.shared.size());
        m_shared = Eigen::MatrixXd::Zero(n, n);
        for (std::size_t p = 0; p < problem.pieces.size(); ++p) add(problem, problem.pieces[p], z.of(p), n);
    }
    const Eigen::MatrixXd& shared() const { return m_shared; }
    double meanSquare() const { return m_measurements > 0.0 ? m_squares / m_measurements : 0.0; }

private:
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    void add(const FitProblem& problem, const FitPiece& piece, const std::vector<double*>& blocks,
             Eigen::Index n) {
        if (piece.measurements == 0) return;
        const auto rows = static_cast<Eigen::Index>(piece.measurements);
        const auto k = static_cast<Eigen::Index>(piece.own.size());
        RowMajor shared(rows, n), own(rows, k);
        Eigen::VectorXd residuals(rows);
        std::vector<double*> jacobians;
        if (n > 0) jacobians.push_back(shared.data());
        if (k > 0) jacobians.push_back(own.data());
        if (!PieceCost(problem, piece).Evaluate(blocks.data(), residuals.data(), jacobians.data())) return;
        m_squares += residuals.squaredNorm();
        m_measurements += piece.independent;
        if (n == 0) return;
        m_shared += shared.transpose() * shared;
        if (k == 0) return;
        const Eigen::MatrixXd ownCurvature = own.transpose() * own + Eigen::MatrixXd::Identity(k, k),
                              cross = own.transpose() * shared;
        m_shared -= cross.transpose() * ownCurvature.ldlt().solve(cross);
    }

    Eigen::MatrixXd m_shared;
    double m_squares = 0.0, m_measurements = 0.0;
};

void judge(FitAnswer& answer, const FitProblem& problem, const Curvature& curvature) {
    const auto n = static_cast<Eigen::Index>(problem.shared.size());
    answer.meanSquare = curvature.meanSquare();
    if (n == 0) return;
    const double scale = std::max(1.0, answer.meanSquare);
    const Eigen::MatrixXd told = curvature.shared() / scale;  // a misfit beyond the noise tells less
    const Eigen::MatrixXd spread = (told + Eigen::MatrixXd::Identity(n, n)).inverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> directions(told);
    for (Eigen::Index i = n; i-- > 0;)
        answer.sharpness.push_back(std::sqrt(std::max(0.0, directions.eigenvalues()[i])));
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j)
            answer.covariance.push_back(spread(i, j) * problem.shared[static_cast<std::size_t>(i)].prior *
                                        problem.shared[static_cast<std::size_t>(j)].prior);
        answer.deviation.push_back(std::sqrt(std::max(0.0, spread(i, i))) *
                                   problem.shared[static_cast<std::size_t>(i)].prior);
    }
}

}  // namespace

double FitAnswer::correlation(std::size_t i, std::size_t j) const {
    return covariance[i * deviation.size() + j] / (deviation[i] * deviation[j]);
}

FitAnswer leastSquares(const FitProblem& problem) {
    Blocks z(problem);
    ceres::Problem ceresProblem;
    bound(ceresProblem, problem.shared, z.shared);
    for (std::size_t p = 0; p < problem.pieces.size(); ++p) {
        bound(ceresProblem, problem.pieces[p].own, z.own[p]);
        if (problem.pieces[p].measurements > 0 && !z.of(p).empty())
            ceresProblem.AddResidualBlock(new PieceCost(problem, problem.pieces[p]), nullptr, z.of(p));
    }
    Watch watch(problem);
    ceres::Solver::Summary summary;
    ceres::Solve(options(watch), &ceresProblem, &summary);
    FitAnswer answer;
    answer.found = summary.IsSolutionUsable();
    answer.settled = summary.termination_type == ceres::CONVERGENCE;
    answer.shared = inUnits(problem.shared, z.shared.data());
    for (std::size_t p = 0; p < problem.pieces.size(); ++p)
        answer.own.push_back(inUnits(problem.pieces[p].own, z.own[p].data()));
    if (answer.found) judge(answer, problem, Curvature(problem, z));
    return answer;
}

}  // namespace sagara::core
