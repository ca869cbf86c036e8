#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/assess/Mission.h"
#include "core/base/Utc.h"
#include "core/bridge/OwnShip.h"
#include "core/bridge/PilotScript.h"
#include "core/exercise/Command.h"
#include "core/exercise/Documents.h"
#include "core/world/Area.h"
#include "core/world/Target.h"

namespace sagara::core {

/// When an event of the scenario happens by itself. With neither time nor zone only a command fires it.
struct EventTrigger {
    std::optional<double> time_s;
    bool zone = false;  ///< the graded ship comes into a circle
    NorthEast centre;
    double radius_m = 0.0;
};

/// Something the scenario does: a trigger and the orders it gives.
struct ScenarioEvent {
    std::string id;
    std::string title;
    EventTrigger trigger;
    struct Given {
        std::uint8_t ship;
        Order order;
    };
    std::vector<Given> orders;
};

/// What a world is built for. To be looked at (on a wall, in a check) it needs no hulls in waves, which are
/// the work of a second or two each where the documents bring none: its ships would feel no sea.
enum class WorldUse : std::uint8_t { Sail, Look };

/// Everything about an exercise that does not change while it runs: area, vessels, scenario, and all that is
/// worked out from them once. Immutable after buildWorld; shared by every State of the exercise.
struct World {
    World(Area worldArea, std::uint64_t worldSeed);

    std::uint64_t seed;
    WorldUse use = WorldUse::Sail;
    Area area;
    WaveTable waves;
    GustTable gusts;
    TidePrediction tide;
    std::vector<HighWater> highWaters;  ///< where there are streams
    Streams streams;                    ///< of the scenario, or else of the area
    std::vector<SeaSystem> sea;         ///< the scenario's own; empty: the sea follows the wind
    WindProfile windProfile = WindProfile::Uniform;

    std::string scenarioId;
    std::string scenarioName;
    Utc start;
    double longest_s = 0.0;  ///< the exercise ends then, whatever is left
    Weather weather;
    std::array<LevelPreset, kLevels> levels;
    std::vector<std::unique_ptr<const OwnShip>> ships;  ///< the first is graded
    std::vector<TargetLayout> targets;
    std::vector<ScenarioEvent> events;
    Route route;
    RoutePath path;
    Mission mission;
    PilotScript pilot;
    ExerciseDocuments documents;

    const LevelPreset& level(int number) const { return levels[static_cast<std::size_t>(number - 1)]; }
};

/// Builds the world of a scenario from the texts it names. All problems of all documents at once; nothing
/// half built.
Result<std::shared_ptr<const World>, config::Problems> buildWorld(const ExerciseDocuments& documents,
                                                                  std::uint64_t seed,
                                                                  WorldUse use = WorldUse::Sail);

}  // namespace sagara::core
