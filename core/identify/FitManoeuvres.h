#pragma once

#include "core/identify/Coefficient.h"
#include "core/identify/LeastSquares.h"
#include "core/identify/TrialMisfit.h"

namespace sagara::core {

struct ManoeuvreFitOptions {
    std::string model;             ///< empty: her first
    std::set<std::string> groups;  ///< see coefficientsOf
    std::function<bool(int iteration)> watch;
};

struct FittedCoefficient {
    Coefficient coefficient;
    double before = 0.0, after = 0.0, deviation = 0.0;
    /// Whether the trials know it better than was believed before them: by a tenth at least.
    bool told() const { return deviation < 0.9 * coefficient.prior; }
};

struct FittedTrial {
    std::string name;
    TrialKind kind = TrialKind::Turning;
    TrialStart start;
    TrialMisfit::Rms before, after;  ///< each with the start that suits it best
};

/// Two coefficients of which the trials tell little more than one combination.
struct Tie {
    std::size_t first = 0, second = 0;
    double correlation = 0.0;
};

/// X_uu: what holds her back straight ahead, over the square of the speed.
struct FittedResistance {
    double speed_mps = 0.0;  ///< at which it was taken: the fastest approach
    double before_kgpm = 0.0, after_kgpm = 0.0, deviation_kgpm = 0.0;
};

struct ManoeuvreFit {
    bool found = false;  ///< false: the model leaves the numbers at its start
    bool settled = false;
    std::vector<FittedCoefficient> coefficients;
    std::vector<FittedTrial> trials;
    std::vector<Tie> ties;
    std::vector<double> sharpness;  ///< see FitAnswer
    double meanSquare = 0.0;
    /// None: her model holds thrust and resistance in balance and tells neither.
    std::optional<FittedResistance> resistance;
    Vessel vessel;  ///< with what was found
};

/// Fits coefficients of one model to all trials of a vessel together (those of motion logs excepted) by
/// output error: the model is run through each trial, with a start of its own, and compared with every number
/// of the record. Trials of decay count only where the model itself owns roll.
ManoeuvreFit fitManoeuvres(const Vessel& vessel, const std::vector<SeaTrial>& trials,
                           const ManoeuvreFitOptions& options = {});

}  // namespace sagara::core
