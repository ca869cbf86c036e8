#pragma once

#include <cstdint>
#include <vector>

#include "core/assess/Mission.h"
#include "core/bridge/OwnShip.h"
#include "core/exercise/Weather.h"
#include "core/exercise/World.h"
#include "core/world/Target.h"

namespace sagara::core {

/// Layout of the archived State. Grows with every change of its fields: an older recording is then replayed
/// from its kinematic track.
inline constexpr std::uint32_t kStateVersion = 5;

/// Everything about an exercise that changes. A value: copy it to look ahead, to go back, to try something
/// else.
struct State {
    std::int64_t tick = 0;
    int level = 1;
    WeatherState weather;
    std::vector<OwnShipState> ships;
    std::vector<TargetState> targets;  ///< those of the World, then the added ones
    std::vector<TargetLayout> added;   ///< by the trainer, at most kMostAddedTargets; none ever goes
    std::vector<std::uint8_t> fired;   ///< events of the scenario that have happened
    Assessment assessment;             ///< of the first own ship
    std::int64_t failedTick = -1;      ///< when the mission failed
    bool finished = false;
    bool stopped = false;  ///< a value was not finite

    SimTime time() const { return timeOfTick(tick); }

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.tick, self.level, self.weather, self.ships, self.targets, self.added, self.fired,
           self.assessment, self.failedTick, self.finished, self.stopped);
    }
};

inline constexpr std::size_t kMostAddedTargets = 32;
/// What is known of a target: index as in State::targets.
inline const TargetLayout& targetLayout(const World& world, const std::vector<TargetLayout>& added,
                                        std::size_t index) {
    return index < world.targets.size() ? world.targets[index] : added[index - world.targets.size()];
}
inline const TargetLayout& targetLayout(const World& world, const State& state, std::size_t index) {
    return targetLayout(world, state.added, index);
}

/// The exercise at its first moment. Level 1 to 5.
State startState(const World& world, int level);

/// Names the bytes of a State.
std::uint64_t stateHash(const State& state);

}  // namespace sagara::core
