#include "app/run/Quantile.h"

#include <algorithm>
#include <cmath>

namespace sagara::run {

double quantile_ms(std::vector<std::int64_t> values_us, double share) {
    if (values_us.empty()) return 0.0;
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values_us.size())));
    const auto at = values_us.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
    std::nth_element(values_us.begin(), at, values_us.end());
    return 1e-3 * static_cast<double>(*at);
}

}  // namespace sagara::run
