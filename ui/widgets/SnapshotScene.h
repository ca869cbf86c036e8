#pragma once

#include "core/exercise/Prediction.h"
#include "core/exercise/Snapshot.h"
#include "ui/widgets/ChartScene.h"

/// What a chart shows of a running exercise. Ids are indices: of World::ships, of World::targets.
namespace sagara::ui {

std::vector<ChartShip> ownShipsOf(const core::World& world, const core::Snapshot& now);
std::vector<ChartShip> targetsOf(const core::World& world, const core::Snapshot& now);

/// Anchors on the ground. The swinging circle is what the stern can reach with the cable stretched: the
/// cable's length on the level plus the way from the hawse to the stern.
std::vector<ChartAnchor> anchorsOf(const core::World& world, const core::Snapshot& now);

/// Where the tasks are to be done, those done as done, and where criteria hold. They change only when a task
/// is done.
std::vector<ChartZone> zonesOf(const core::Mission& mission, const std::vector<core::TaskView>& tasks);

ChartPrediction predictionOf(const core::World& world, std::size_t ship,
                             const std::vector<core::PredictedPose>& poses);

}  // namespace sagara::ui
