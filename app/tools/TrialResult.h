#pragma once

#include <optional>
#include <string>

#include "core/identify/Trial.h"
#include "core/vessel/Vessel.h"

namespace sagara::tools {

/// Rows every `dt_s`, with whole steps of the integrator between them that are not longer than usual.
void takeRows(core::TrialOptions& options, std::optional<double> dt_s);

/// Writes the time series of a trial, or prints its measures and writes the series only to a file. Tells when
/// the ship did not get there. Returns the exit code.
int writeTrial(const core::Vessel& vessel, const core::Trial& trial, const std::string& series, bool measures,
               const std::string& csv);

}  // namespace sagara::tools
