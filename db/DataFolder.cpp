#include "db/DataFolder.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace sagara::db {
namespace {

namespace fs = std::filesystem;
using core::Result;

std::string_view environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

/// XDG Base Directory Specification 0.8: a relative $XDG_DATA_HOME is to be ignored.
std::optional<fs::path> xdgFolder() {
    const fs::path data = environment("XDG_DATA_HOME");
    if (data.is_absolute()) return data / "sagara";
    const fs::path home = environment("HOME");
    if (home.is_absolute()) return home / ".local/share/sagara";
    return std::nullopt;
}

/// Why this cannot be a folder of ours; nothing when it is one, made if need be.
std::optional<std::string> trouble(const fs::path& folder) {
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
        return folder.string() + " is a file, expected a folder for Sagara's data";
    }
    fs::create_directories(folder, error);
    if (error) return folder.string() + " cannot be made: " + error.message();
    if (::faccessat(AT_FDCWD, folder.c_str(), R_OK | W_OK | X_OK, AT_EACCESS) == 0) return std::nullopt;
    return folder.string() + " may not be written, expected a folder where this user may make files";
}

}  // namespace

Result<DataFolder, std::string> DataFolder::open(const std::optional<fs::path>& given) {
    if (given && given->empty())
        return std::string("the name of the data folder is empty, expected a folder");
    const std::optional<fs::path> folder = given ? given : xdgFolder();
    if (!folder)
        return std::string(
            "there is no data folder: neither XDG_DATA_HOME nor HOME is set; name one with --data");
    if (const auto why = trouble(*folder)) return *why;
    const DataFolder opened(fs::canonical(*folder));
    if (const auto why = trouble(opened.recordings())) return *why;
    return opened;
}

std::string DataFolder::nameOf(const fs::path& file) const {
    std::error_code error;
    fs::path whole = fs::weakly_canonical(fs::absolute(file), error);
    if (error) whole = fs::absolute(file).lexically_normal();
    const fs::path relative = whole.lexically_relative(m_root);
    const bool isInside = !relative.empty() && *relative.begin() != "..";
    return isInside ? relative.string() : whole.string();
}

}  // namespace sagara::db
