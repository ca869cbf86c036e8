#pragma once

#include <filesystem>
#include <optional>

#include "render/scene/Picture.h"

namespace sagara::render {

/// Reads back what writePng wrote, and nothing else: 8-bit RGB, no filter. Nothing when it cannot.
std::optional<Picture> readOwnPng(const std::filesystem::path& path);

}  // namespace sagara::render
