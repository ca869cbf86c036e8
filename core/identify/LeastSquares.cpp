#include "core/identify/LeastSquares.h"

#include <ceres/ceres.h>

#include <algorithm>

#include "core/identify/FitCurvature.h"

namespace sagara::core {
namespace {

/// One piece as Ceres sees it. Blocks: shared, own.
class PieceCost final : public ceres::CostFunction {
public:
    PieceCost(const FitProblem& problem, const FitPiece& piece) : m_misfit(problem, piece) {
        set_num_residuals(static_cast<int>(piece.measurements));
        for (const auto* block : {&problem.shared, &piece.own})
            if (!block->empty()) mutable_parameter_block_sizes()->push_back(static_cast<int>(block->size()));
    }

    bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override {
        PieceMisfit::Blocks z;
        for (std::size_t b = 0; b < parameter_block_sizes().size(); ++b)
            z.emplace_back(blocks[b], blocks[b] + parameter_block_sizes()[b]);
        std::vector<double> here(static_cast<std::size_t>(num_residuals()));
        if (!m_misfit.at(z, here)) return false;
        std::copy(here.begin(), here.end(), residuals);
        for (std::size_t b = 0; jacobians && b < z.size(); ++b)
            if (jacobians[b]) m_misfit.differentiate(z, b, here, jacobians[b]);
        return true;
    }

private:
    PieceMisfit m_misfit;
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
    std::vector<PieceMisfit::Blocks> copies() const {
        std::vector<PieceMisfit::Blocks> all(own.size());
        for (std::size_t p = 0; p < own.size(); ++p) {
            if (!shared.empty()) all[p].push_back(shared);
            if (!own[p].empty()) all[p].push_back(own[p]);
        }
        return all;
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
    if (answer.found) judge(answer, problem, z.copies());
    return answer;
}

}  // namespace sagara::core
