#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/Config.h"
#include "core/exercise/Command.h"

namespace sagara::core {

/// Names an order can use: what the exercise has.
struct OrderNames {
    struct Ship {
        std::string id;
        std::vector<std::string> lines;
        std::vector<std::string> shafts;
        std::vector<std::string> anchors;
        std::vector<std::string> thrusters;
    };
    std::vector<Ship> ships;
    std::vector<std::string> targets;  ///< of the scenario; those added later are "added-1" and so on
    std::vector<std::string> events;
    std::optional<LocalFrame> frame;  ///< of the area; without it no order may name a place
};

struct World;
OrderNames orderNames(const World& world);

/// One order from its object: "order" names the kind, "ship" the own ship (default the first). See
/// OrderDocument.cpp for the members of each kind; README.md of this folder lists them for people.
struct NamedOrder {
    std::uint8_t ship = 0;
    Order order;
};
std::optional<NamedOrder> readOrder(config::Reader& in, const OrderNames& names);

/// {"height_m", "period_s", "from_deg"} and, if wanted, "gamma" and "spreading".
WaveSystem readSwell(const config::Node& node);

/// A command file: {"document": "commands", "version": 1, "scenario": id, "commands": [{"time_s": ..,
/// "order": .., ..}]}, times not falling. The scenario is for people and for checking the file; any that has
/// the names will do.
Result<std::vector<Command>, config::Problems> loadCommands(const std::string& name, std::string_view text,
                                                            const OrderNames& names);

}  // namespace sagara::core
