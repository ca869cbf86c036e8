#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "render/scene/shape/Solid.h"

namespace sagara::render {

/// Pixels of a texture, rows from the top, red in the lowest byte.
struct TextureImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> abgr;

    std::optional<Paint> onlyColour() const;  ///< where all pixels are (nearly) the same
};

/// Reads a PNG file. The error names the file.
core::Result<TextureImage, std::string> readTexture(const std::filesystem::path& file);

/// Triangles with a texture: a place in it for each vertex, right and down; colours multiply it.
struct TexturedSolid {
    Solid solid;
    std::vector<std::array<float, 2>> places;
    std::shared_ptr<const TextureImage> texture;
};

}  // namespace sagara::render
