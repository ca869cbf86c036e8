#pragma once

#include <string>

#include "core/base/Config.h"

namespace sagara::core {

/// How well a group of a vessel's numbers is known.
enum class Quality { Measured, Fitted, Published, Estimated, Tuned };

struct Provenance {
    Quality quality = Quality::Estimated;
    std::string source;  ///< paper, table, page; for tuned values author and date
};

/// "source" and "quality" of a group; both must be there.
Provenance readProvenance(config::Reader& in);
const char* qualityName(Quality quality);

}  // namespace sagara::core
