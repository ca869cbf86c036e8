#include "ui/trainee/AisTargets.h"

#include "core/bridge/AisCarriage.h"
#include "ui/widgets/SnapshotScene.h"

namespace sagara::ui::console {

std::vector<ChartShip> aisTargetsOf(const core::World& world, const core::Snapshot& now,
                                    std::size_t ownShip) {
    std::vector<ChartShip> shown;
    for (ChartShip& ship : targetsOf(world, now)) {
        if (!core::carriesAis(core::targetLayout(world, now.added, static_cast<std::size_t>(ship.id))))
            continue;
        ship.hostile = false;  // AIS does not tell
        shown.push_back(std::move(ship));
    }
    std::vector<ChartShip> others = ownShipsOf(world, now);
    for (ChartShip& ship : others)
        if (static_cast<std::size_t>(ship.id) != ownShip) {
            ship.id = -1 - ship.id;
            shown.push_back(std::move(ship));
        }
    return shown;
}

}  // namespace sagara::ui::console
