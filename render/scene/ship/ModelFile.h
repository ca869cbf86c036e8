#pragma once

#include <filesystem>
#include <string>

#include "core/base/Result.h"
#include "core/vessel/Picture.h"
#include "render/scene/ship/ShipShape.h"

namespace sagara::render {

/// A ship's shape from a model file and where it has its lights, in the ship's own frame and size.
struct ShipModel {
    ShipShape shape;
    LightPoints lights;
};

/// Reads the picture's file below `models` with Assimp: AC3D, OBJ, glTF, Collada, 3DS, FBX, PLY, STL;
/// textures are PNG files beside it. `length_m` and `beam_m` are the ship's, to fit it to. Sizes are bounded;
/// the error names the file and what is the matter with it. Not from two threads at once: Assimp has one log.
core::Result<ShipModel, std::string> readModel(const std::filesystem::path& models,
                                               const core::Picture& picture, double length_m, double beam_m);

/// Whether '*' for any letters, and every other letter for itself, give the name.
bool matches(const std::string& pattern, const std::string& name);

}  // namespace sagara::render
