#pragma once

#include <string>

#include "core/base/Result.h"
#include "core/exercise/Documents.h"
#include "core/exercise/World.h"
#include "ui/widgets/PreparedChart.h"

namespace sagara::ui {

/// An exercise with its chart: what takes time before a desk or a console can be shown.
struct PreparedExercise {
    std::shared_ptr<const core::World> world;
    std::shared_ptr<const PreparedChart> chart;  ///< with the safety contour of her first own ship
};

/// In any thread; some tenths of a second. The error is for the person who chose.
core::Result<PreparedExercise, std::string> prepareExercise(const core::ExerciseDocuments& documents);

/// The chart of an exercise; the safety contour is the draught of own ship `ship` and 1.5 m, 5 m without
/// one.
std::shared_ptr<const PreparedChart> prepareChart(const std::shared_ptr<const core::World>& world,
                                                  std::size_t ship = 0);

}  // namespace sagara::ui
