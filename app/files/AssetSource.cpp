#include "app/files/AssetSource.h"

#include <algorithm>

#include "app/files/Files.h"
#include "core/base/Config.h"

namespace sagara::files {
namespace fs = std::filesystem;

fs::path assetFolder() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path installed = program.parent_path().parent_path() / "share" / "sagara" / "assets";
    if (fs::is_directory(installed, ignored)) return installed;
    return SAGARA_SOURCE_ASSETS;
}

fs::path AssetSource::pathOf(core::DocumentKind kind, const std::string& id) const {
    switch (kind) {
        case core::DocumentKind::Vessel:
            return m_folder / "vessels" / (id + ".json");
        case core::DocumentKind::Area:
            return m_folder / "areas" / id / "area.json";
        case core::DocumentKind::Scenario:
            return m_folder / "scenarios" / (id + ".json");
        case core::DocumentKind::Picture:
            return m_folder / "pictures" / (id + ".json");
    }
    return {};
}

std::optional<std::string> AssetSource::find(core::DocumentKind kind, const std::string& id) const {
    if (!core::config::isId(id)) return std::nullopt;
    auto text = readTextFile(pathOf(kind, id));
    if (!text) return std::nullopt;
    return std::move(text).value();
}

std::vector<std::string> AssetSource::ids(core::DocumentKind kind) const {
    const fs::path sample = pathOf(kind, "x");
    const bool folders = kind == core::DocumentKind::Area;
    std::vector<std::string> ids;
    std::error_code ignored;
    for (const auto& entry :
         fs::directory_iterator(folders ? m_folder / "areas" : sample.parent_path(), ignored)) {
        if (folders || entry.path().extension() == ".json") ids.push_back(entry.path().stem().string());
    }
    std::sort(ids.begin(), ids.end());
    return ids;
}

}  // namespace sagara::files
