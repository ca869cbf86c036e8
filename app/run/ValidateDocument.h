#pragma once

#include <filesystem>

#include "app/run/Store.h"

namespace sagara::run {

/// Checks a document of any kind and prints every problem. Scenarios, command files and rubrics are checked
/// with what they name. Returns the exit code.
int validateDocument(const Store& store, const std::filesystem::path& path);

}  // namespace sagara::run
