#pragma once

#include <string>

#include "app/run/Store.h"
#include "app/tools/VesselChoice.h"
#include "core/seakeeping/HullForm.h"

namespace sagara::tools {

/// The hull a tool is asked about: that of a vessel, or of a file with stations, offsets or coefficients.
struct HullChoice {
    VesselChoice ship;
    std::string file;  ///< in place of the vessel
};

/// A file with stations, offsets or coefficients. The error is for the person who named it.
core::Result<core::HullForm, std::string> readHullFile(const std::string& file);
/// The error is for the person who asked.
core::Result<core::HullForm, std::string> openHull(const run::Store& store, const HullChoice& choice);

}  // namespace sagara::tools
