#include "app/view/ScenarioWorld.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/Units.h"
#include "core/exercise/Session.h"

namespace sagara::view {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> readText(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) return std::nullopt;
    return text.str();
}

fs::path pathOf(const fs::path& assets, core::DocumentKind kind, const std::string& id) {
    switch (kind) {
        case core::DocumentKind::Vessel:
            return assets / "vessels" / (id + ".json");
        case core::DocumentKind::Area:
            return assets / "areas" / id / "area.json";
        case core::DocumentKind::Scenario:
            return assets / "scenarios" / (id + ".json");
        case core::DocumentKind::Picture:
            return assets / "pictures" / (id + ".json");
    }
    return {};
}

class FolderSource final : public core::DocumentSource {
public:
    explicit FolderSource(fs::path assets) : m_assets(std::move(assets)) {}
    std::optional<std::string> find(core::DocumentKind kind, const std::string& id) const override {
        return core::config::isId(id) ? readText(pathOf(m_assets, kind, id)) : std::nullopt;
    }

private:
    fs::path m_assets;
};

/// The scenario's text with what the request changes. A text that is no JSON stays as it is; the loader
/// tells.
std::string changed(const std::string& text, const ScenarioRequest& r) {
    auto document = nlohmann::json::parse(text, nullptr, false);
    if (!document.is_object()) return text;
    if (r.startUtc) document["startUtc"] = *r.startUtc;
    if (r.wind_kn) document["weather"]["wind"]["speed_kn"] = *r.wind_kn;
    if (r.visibility_m) document["weather"]["visibility_M"] = *r.visibility_m / core::kNauticalMile_m;
    if (r.rain) document["weather"]["rain"] = *r.rain;
    return document.dump();
}

}  // namespace

fs::path assetFolder() {
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path installed = program.parent_path().parent_path() / "share" / "sagara" / "assets";
    return fs::is_directory(installed, ignored) ? installed : fs::path(SAGARA_SOURCE_ASSETS);
}

core::Result<std::shared_ptr<const core::World>, std::string> worldOf(const ScenarioRequest& request) {
    const fs::path file = core::config::isId(request.scenario)
                              ? pathOf(request.assets, core::DocumentKind::Scenario, request.scenario)
                              : fs::path(request.scenario);
    const auto text = readText(file);
    if (!text) return file.string() + " cannot be read";
    const auto documents =
        core::collectDocuments({file.string(), changed(*text, request)}, FolderSource(request.assets));
    if (!documents) return documents.error().text();
    auto world = core::buildWorld(*documents, 1);
    if (!world) return world.error().text();
    return std::move(world).value();
}

std::shared_ptr<const core::Snapshot> sailed(const std::shared_ptr<const core::World>& world, int level,
                                             double until_s) {
    core::Session session(world, core::startState(*world, level), {{0, 0, core::PilotOrder{true}}}, nullptr);
    while (!session.over() && session.state().time().seconds() < until_s) session.step();
    return std::make_shared<core::Snapshot>(core::view(*world, session.state()));
}

}  // namespace sagara::view
