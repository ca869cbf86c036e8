#pragma once

#include <optional>

#include "core/vessel/Machinery.h"

namespace sagara::ui {

/// The step a lever from -1 (full astern) to 1 (full ahead) is nearest to.
core::TelegraphStep nearestStep(double lever);
/// Where that step lies.
double leverOf(core::TelegraphStep step);
/// One step up or down, ends held.
core::TelegraphStep stepBy(core::TelegraphStep step, int steps);

/// A lever without notches made into one that has them: a step is left only when the lever is clearly beyond
/// the edge, so that a hand resting on the edge does not ring the telegraph. The first reading is only taken
/// note of.
class TelegraphLever final {
public:
    /// The step when it is a new one.
    std::optional<core::TelegraphStep> moved(double lever);

private:
    std::optional<core::TelegraphStep> m_step;
};

}  // namespace sagara::ui
