#pragma once

#include <optional>
#include <string>

#include "core/base/Result.h"
#include "core/exercise/Documents.h"
#include "core/vessel/Vessel.h"

namespace sagara::tools {

/// The ship a tool is asked about, and in what water.
struct VesselChoice {
    std::string vessel;             ///< id or file
    std::string model;              ///< empty: the first of her document
    std::optional<double> depth_m;  ///< none: deep
};

/// Her document, read. The error is for the person who asked: no such document, or all its problems.
core::Result<core::Vessel, std::string> openVessel(const core::DocumentSource& source,
                                                   const VesselChoice& choice);

}  // namespace sagara::tools
