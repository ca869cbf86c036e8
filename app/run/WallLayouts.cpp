#include "app/run/WallLayouts.h"

#include <algorithm>
#include <cstdlib>

#include "app/files/AssetSource.h"
#include "app/files/Files.h"
#include "core/base/Config.h"

namespace sagara::run {
namespace fs = std::filesystem;

core::Result<wall::Layout, std::string> findWallLayout(const std::string& idOrFile) {
    const bool id = core::config::isId(idOrFile);
    const fs::path path = id ? files::assetFolder() / "walls" / (idOrFile + ".json") : fs::path(idOrFile);
    const auto text = files::readTextFile(path);
    if (!text) return text.error().message;
    auto loaded = wall::loadLayout(path.filename().string(), *text);
    if (!loaded) return loaded.error().text();
    return std::move(loaded).value();
}

std::vector<wall::Layout> wallLayouts() {
    std::vector<wall::Layout> layouts;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(files::assetFolder() / "walls", ignored)) {
        if (entry.path().extension() != ".json") continue;
        auto layout = findWallLayout(entry.path().string());
        if (layout) layouts.push_back(std::move(layout).value());
    }
    std::sort(layouts.begin(), layouts.end(), [](const auto& a, const auto& b) {
        return std::pair(a.channels.size(), a.id) < std::pair(b.channels.size(), b.id);
    });
    return layouts;
}

fs::path viewProgram() {
    if (const char* given = std::getenv("SAGARA_VIEW")) return given;
    std::error_code ignored;
    const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    const fs::path built = folder.parent_path() / "sagara-view" / "sagara-view";
    return fs::exists(built, ignored) ? built : folder / "sagara-view";
}

}  // namespace sagara::run
