#include "ui/report/Axis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sagara::report {
namespace {

/// The smallest of 1, 2 or 5 times a power of ten that is not less.
double roundStep(double least) {
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * decade >= least * (1.0 - 1e-9)) return factor * decade;
    }
    return 10.0 * decade;
}

double stepFor(double span, const AxisRule& rule) {
    const double least = std::max(span, 1e-6) / std::max(1, rule.tickCount);
    for (const double step : rule.steps) {
        if (step >= least) return step;
    }
    return rule.steps.empty() ? roundStep(least) : rule.steps.back();
}

}  // namespace

std::vector<double> Axis::ticks() const {
    std::vector<double> at;
    const auto count = std::lround((high - low) / step);
    for (long i = 0; i <= std::min(count, 200L); ++i) at.push_back(low + static_cast<double>(i) * step);
    return at;
}

Axis axisFor(std::span<const double> values, const AxisRule& rule) {
    double low = rule.least, high = rule.most;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (rule.symmetric) {
        high = std::max(std::abs(low), std::abs(high));
        low = -high;
    }
    if (high <= low) high = low + 1.0;
    const double step = stepFor(high - low, rule);
    return {std::floor(low / step + 1e-9) * step, std::ceil(high / step - 1e-9) * step, step};
}

double timeStep_s(double end_s) {
    constexpr std::array<double, 12> kSteps_s{5, 10, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400};
    for (const double step_s : kSteps_s) {
        if (end_s / step_s <= 11.0) return step_s;
    }
    return 86400.0;
}

}  // namespace sagara::report
