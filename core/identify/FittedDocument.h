#pragma once

#include "core/identify/FitManoeuvres.h"
#include "core/identify/SwingFit.h"

namespace sagara::core {

/// The vessel document with what was found in it: fitted numbers with five figures, the quality of every
/// group touched `fitted`, its source saying by which trials and how well. Coefficients the trials cannot
/// tell better than was believed are left as they were fitted too: only together do they give these tracks.
/// `text`: a document that loadVessel takes.
std::string fittedDocument(std::string_view text, std::string_view model, const ManoeuvreFit& manoeuvres,
                           const std::vector<SwingFit>& swings);

}  // namespace sagara::core
