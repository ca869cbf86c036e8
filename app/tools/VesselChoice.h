#pragma once

#include <string>

#include "core/base/Result.h"
#include "core/exercise/Documents.h"
#include "core/motion/ShipMotion.h"
#include "core/vessel/Vessel.h"

namespace sagara::tools {

/// The ship a tool is asked about, and in what water.
struct VesselChoice {
    std::string vessel;  ///< id or file
    std::string model;   ///< empty: the first of her document
    double depth_m = core::kDeepWater_m;
};

/// Her document, read, and known to have that model. The error is for the person who asked: no such document,
/// all its problems, or which models there are.
core::Result<core::Vessel, std::string> openVessel(const core::DocumentSource& source,
                                                   const VesselChoice& choice);

}  // namespace sagara::tools
