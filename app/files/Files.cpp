#include "app/files/Files.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace sagara::files {
namespace fs = std::filesystem;
namespace {

FileError because(const fs::path& path, const std::string& what) {
    return {path.string() + ": " + what + " (" + std::strerror(errno) + ")"};
}

/// Reads into any contiguous container of bytes.
template <typename Container>
core::Result<Container, FileError> readFile(const fs::path& path) {
    errno = 0;
    std::error_code failed;
    if (fs::is_directory(path, failed)) return FileError{path.string() + ": is a folder, expected a file"};
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) return because(path, "cannot be read");
    Container content;
    content.resize(static_cast<std::size_t>(file.tellg()));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(content.size()));
    if (!file) return because(path, "cannot be read to its end");
    return content;
}

}  // namespace

core::Result<std::string, FileError> readTextFile(const fs::path& path) {
    return readFile<std::string>(path);
}
core::Result<core::Bytes, FileError> readBinaryFile(const fs::path& path) {
    return readFile<core::Bytes>(path);
}

std::optional<FileError> writeTextFile(const fs::path& path, std::string_view text) {
    std::error_code failed;
    const fs::file_type type = fs::symlink_status(path, failed).type();
    const bool replaced = type == fs::file_type::not_found || type == fs::file_type::regular;
    const fs::path written = replaced ? fs::path(path.string() + ".new") : path;
    errno = 0;
    std::ofstream file(written, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    failed.clear();
    if (file && replaced) fs::rename(written, path, failed);
    if (file && !failed) return std::nullopt;
    const FileError error = because(path, "cannot be written");
    if (replaced) fs::remove(written, failed);
    return error;
}

}  // namespace sagara::files
