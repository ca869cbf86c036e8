#pragma once

#include <string>
#include <vector>

#include "app/import/CoastSource.h"
#include "app/import/ImportDescription.h"

namespace sagara::importer {

/// Where the bollards and fenders of a berth stand, in frame N.
struct BerthPlan {
    struct Bollard {
        std::string id;
        core::NorthEast position;
    };
    std::vector<Bollard> bollards;
    std::vector<core::NorthEast> fenders;
};

BerthPlan planBerth(const BerthRules& rules, const core::LocalFrame& frame);

/// A problem under `path` when the face does not lie on a quay or jetty of the shoreline, or has the land on
/// the wrong side.
void checkFace(const BerthRules& rules, const LocalCoast& coast, const core::LocalFrame& frame,
               const std::string& path, core::config::Problems& problems);

}  // namespace sagara::importer
