#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/identify/FitManoeuvres.h"
#include "core/identify/NomotoFit.h"
#include "core/identify/SwingFit.h"

namespace sagara::tools {

/// All that was found of a vessel.
struct Identified {
    std::string vessel, model;
    core::ManoeuvreFit manoeuvres;
    std::optional<core::NomotoFit> nomoto;
    std::vector<core::SwingFit> swings;
    std::vector<std::string> unused;  ///< trials that told nothing of this model
};

/// For people: trial by trial before and after, coefficient by coefficient, and what the trials cannot tell.
std::string identifyReport(const Identified& found);
/// name,before,after,deviation,prior,told.
std::string coefficientsCsv(const Identified& found);

}  // namespace sagara::tools
