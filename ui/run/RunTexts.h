#pragma once

#include <QString>

#include "core/exercise/Event.h"
#include "core/exercise/InstructorOrders.h"
#include "core/exercise/World.h"

/// Times of an exercise in words.
namespace sagara::ui {

/// "12:05", "1:02:05".
QString elapsed(core::SimTime time);
/// Time of day at the area, "09:12:05".
QString localTime(const core::World& world, core::SimTime time);
/// "03:42:05 UTC".
QString utcTime(const core::World& world, core::SimTime time);
/// What happened, in a line for the log; empty for what is of no interest to a trainer.
QString eventText(const core::World& world, const core::Event& event);
/// With the names of the targets that were added in the run.
QString eventText(const core::World& world, const std::vector<core::TargetLayout>& added,
                  const core::Event& event);
QString reportText(core::ReportKind kind);

}  // namespace sagara::ui
