#pragma once

#include <string>
#include <string_view>

#include "core/base/Problems.h"
#include "core/base/Result.h"

namespace sagara::core {

/// The whole document of a vessel of which only particulars are known, all or in part: what it does not have
/// is estimated from its group "particulars" (vesselFromParticulars), which then goes. A group it has is
/// taken as it is, of "hull" each member. A text without "particulars", or no document at all, comes back
/// unchanged.
Result<std::string, config::Problems> completeVessel(const std::string& name, std::string_view text);

}  // namespace sagara::core
