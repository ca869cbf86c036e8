#pragma once

#include <memory>
#include <vector>

#include "core/exercise/World.h"
#include "ui/widgets/ChartScene.h"
#include "ui/widgets/PreparedChart.h"

namespace sagara::ui::test {

/// Galle, prepared with a safety contour of 5 m; made once.
std::shared_ptr<const PreparedChart> galle();
std::shared_ptr<const core::World> lesson();

/// The lesson at level 3 sailed by the pilot, as a chart shows it at some of its minutes (ascending).
std::vector<ChartScene> sailedLesson(const std::vector<double>& minutes);

/// The lesson's route, tasks and ships as they stand at the beginning.
ChartScene lessonAtBerth();

}  // namespace sagara::ui::test
