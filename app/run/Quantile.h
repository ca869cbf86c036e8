#pragma once

#include <cstdint>
#include <vector>

namespace sagara::run {

/// Nearest rank, in milliseconds; 0 of an empty list.
double quantile_ms(std::vector<std::int64_t> values_us, double share);

}  // namespace sagara::run
