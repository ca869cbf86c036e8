#pragma once

#include "core/identify/PieceMisfit.h"

namespace sagara::core {

/// Says in the answer, of which the unknowns are found, how well they are known. `z`: of each piece.
void judge(FitAnswer& answer, const FitProblem& problem, const std::vector<PieceMisfit::Blocks>& z);

}  // namespace sagara::core
