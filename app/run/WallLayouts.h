#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/wall/Layout.h"

namespace sagara::run {

/// The walls shipped in assets/walls; those that cannot be read are left out.
std::vector<wall::Layout> wallLayouts();
/// By id under assets/walls, or by file name. The error is for the person who named it.
core::Result<wall::Layout, std::string> findWallLayout(const std::string& idOrFile);

/// sagara-view: what the environment names as SAGARA_VIEW, else as installed or built beside this program.
std::filesystem::path viewProgram();

}  // namespace sagara::run
