#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/exercise/World.h"
#include "render/scene/ship/ShipForm.h"
#include "render/scene/ship/ShipShape.h"

namespace sagara::render {

/// How one ship of the exercise is drawn: from her model where she has one that can be read, else from her
/// form.
struct ShipLook {
    ShipForm form;
    ShipShape shape;
};

struct Fleet {
    std::vector<ShipLook> own;         ///< as World::ships
    std::vector<ShipLook> targets;     ///< as World::targets
    std::vector<std::string> remarks;  ///< for a person: which models could not be used, and why
};

/// How a target looks that the scenario does not have. `index` as in Moment's targets.
ShipLook lookOfAdded(const core::TargetLayout& target, std::size_t index);
/// Whether two of them look alike.
bool looksLike(const core::TargetLayout& a, const core::TargetLayout& b);

/// `assets` has models/ and pictures/; a model that is not there is looked for in `ownModels`.
Fleet fleetOf(const core::World& world, const std::filesystem::path& assets,
              const std::filesystem::path& ownModels = {});

}  // namespace sagara::render
