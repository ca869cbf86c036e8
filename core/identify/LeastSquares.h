#pragma once

#include <functional>
#include <span>
#include <vector>

namespace sagara::core {

/// A number that a fit looks for. What is believed of it beforehand counts like one measurement: `start`
/// with the standard deviation `prior`. It stays between `low` and `high`.
struct Unknown {
    double start = 0.0;
    double prior = 1.0;
    double low = -1e300;
    double high = 1e300;
};

/// Some measurements and how far a model is from them: differences over their standard deviations, as a
/// smooth function of the shared unknowns and of the piece's own. False: the model left the numbers.
/// Differences beyond five standard deviations count by their size, no longer by its square (pseudo-Huber).
struct FitPiece {
    std::vector<Unknown> own;
    std::size_t measurements = 0;
    double independent = 0.0;  ///< for how many they count: neighbours in time tell the same
    std::function<bool(std::span<const double> shared, std::span<const double> own, std::span<double> misfit)>
        misfit;
};

struct FitProblem {
    std::vector<Unknown> shared;
    std::vector<FitPiece> pieces;
    /// Told before each iteration; false ends the search where it is.
    std::function<bool(int iteration)> watch;
};

struct FitAnswer {
    bool found = false;  ///< false: not even the start could be tried
    bool settled = false;
    std::vector<double> shared;
    std::vector<std::vector<double>> own;  ///< of each piece
    /// Of the shared unknowns, row-major, by the curvature at the answer, prior and own unknowns considered;
    /// enlarged by the mean square of the misfit where that is more than 1.
    std::vector<double> covariance;
    std::vector<double> deviation;  ///< square root of its diagonal
    /// How much better than the prior the measurements alone know each independent combination of the shared
    /// unknowns: prior over measured standard deviation, falling. Below 1 they know less than was believed.
    std::vector<double> sharpness;
    double meanSquare = 0.0;  ///< of the misfit, by independent measurement

    double correlation(std::size_t i, std::size_t j) const;
};

/// Levenberg-Marquardt (Ceres) with bounds, derivatives by central differences of a hundredth of each prior:
/// the same input gives the same answer. Gaussian errors; see Nocedal and Wright (2006), Numerical
/// Optimization, chapter 10, and Press et al. (2007), Numerical Recipes, 15.4 and 15.6, for the covariance.
FitAnswer leastSquares(const FitProblem& problem);

}  // namespace sagara::core
