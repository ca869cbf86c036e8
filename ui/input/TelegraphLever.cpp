#include "ui/input/TelegraphLever.h"

#include <algorithm>
#include <cmath>

namespace sagara::ui {
namespace {

constexpr int kLast = static_cast<int>(core::kTelegraphSteps) - 1;
constexpr double kPitch = 2.0 / kLast;
/// How far beyond the edge of its step, of the lever's half way.
constexpr double kHysteresis = 0.03;

}  // namespace

core::TelegraphStep nearestStep(double lever) {
    const long index = std::lround((std::clamp(lever, -1.0, 1.0) + 1.0) / kPitch);
    return static_cast<core::TelegraphStep>(std::clamp(static_cast<int>(index), 0, kLast));
}

double leverOf(core::TelegraphStep step) { return -1.0 + kPitch * static_cast<int>(step); }

core::TelegraphStep stepBy(core::TelegraphStep step, int steps) {
    return static_cast<core::TelegraphStep>(std::clamp(static_cast<int>(step) + steps, 0, kLast));
}

std::optional<core::TelegraphStep> TelegraphLever::moved(double lever) {
    if (!m_step) {
        m_step = nearestStep(lever);
        return std::nullopt;
    }
    if (std::abs(lever - leverOf(*m_step)) <= 0.5 * kPitch + kHysteresis) return std::nullopt;
    const core::TelegraphStep step = nearestStep(lever);
    if (step == *m_step) return std::nullopt;
    m_step = step;
    return step;
}

}  // namespace sagara::ui
