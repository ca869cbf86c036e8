#pragma once

#include "core/exercise/Snapshot.h"
#include "ui/widgets/ChartScene.h"

namespace sagara::ui::console {

/// The other ships a trainee's chart may show: those that send AIS (core::carriesAis), own ships of the
/// exercise among them.
std::vector<ChartShip> aisTargetsOf(const core::World& world, const core::Snapshot& now, std::size_t ownShip);

}  // namespace sagara::ui::console
