#pragma once

#include <string>

#include "core/seakeeping/HullForm.h"

namespace sagara::core {

/// A hull of tests/reference/seakeeping, "s175" for example.
HullForm referenceHull(const std::string& name);

}  // namespace sagara::core
