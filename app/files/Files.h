#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/Archive.h"
#include "core/base/Result.h"

namespace sagara::files {

/// A file that could not be read or written: a message for a person, which names it.
struct FileError {
    std::string message;
};

core::Result<std::string, FileError> readTextFile(const std::filesystem::path& path);
core::Result<core::Bytes, FileError> readBinaryFile(const std::filesystem::path& path);
/// Whole or not at all: under another name first, then renamed. A device, a pipe or a link is written through
/// and stays what it is.
std::optional<FileError> writeTextFile(const std::filesystem::path& path, std::string_view text);

}  // namespace sagara::files
