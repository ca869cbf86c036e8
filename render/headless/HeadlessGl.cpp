#include "render/headless/HeadlessGl.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

namespace sagara::render {
namespace {

namespace fs = std::filesystem;

/// Beside the program where it is installed, else where it was built.
fs::path libraryPath() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path installed =
        program.parent_path().parent_path() / "lib" / "sagara" / "sagara-headless-gl.so";
    return fs::exists(installed, ignored) ? installed : fs::path(SAGARA_HEADLESS_GL);
}

}  // namespace

std::optional<std::string> useHeadlessGl() {
    static void* library = nullptr;
    if (library != nullptr) return std::nullopt;
    const fs::path path = libraryPath();
    library = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (library != nullptr) return std::nullopt;
    const char* reason = dlerror();
    return path.string() + " cannot be loaded: " + (reason != nullptr ? reason : "unknown reason");
}

bool displayIsSet() {
    const char* display = std::getenv("DISPLAY");
    return display != nullptr && *display != '\0';
}

}  // namespace sagara::render
