#include "core/identify/SeaTrial.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {

const char* trialKindName(TrialKind kind) {
    constexpr std::array names{"turning", "zigzag", "spiral", "stopping", "speed", "decay", "motion-log"};
    static_assert(names.size() == kTrialKinds);
    return names[static_cast<std::size_t>(kind)];
}

std::size_t SeaTrial::rows() const {
    std::size_t most = 0;
    for (const auto& column : columns) most = std::max(most, column.size());
    return most;
}

double SeaTrial::at(Channel c, double time_s) const {
    const std::vector<double>&times = (*this)[Channel::Time], &values = (*this)[c];
    const auto after = std::upper_bound(times.begin(), times.end(), time_s);
    if (after == times.begin()) return values.front();
    if (after == times.end()) return values.back();
    const auto i = static_cast<std::size_t>(after - times.begin());
    const double share = (time_s - times[i - 1]) / (times[i] - times[i - 1]);
    return values[i - 1] + share * (values[i] - values[i - 1]);
}

}  // namespace sagara::core
