#include "render/scene/ship/Fleet.h"

#include <fstream>
#include <sstream>

#include "render/scene/ship/ModelFile.h"

namespace sagara::render {
namespace {

namespace fs = std::filesystem;

core::Result<core::Picture, std::string> pictureOf(const fs::path& assets, const std::string& id) {
    const fs::path file = assets / "pictures" / (id + ".json");
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) return "picture " + file.string() + " cannot be read";
    auto picture = core::loadPicture(file.string(), text.str());
    if (!picture) return picture.error().text();
    return std::move(picture).value();
}

class Builder {
public:
    Builder(const fs::path& assets, const fs::path& ownModels, Fleet& fleet)
        : m_assets(assets), m_ownModels(ownModels), m_fleet(fleet) {}

    /// `picture` null: she has none.
    ShipLook look(const std::string& name, ShipForm form, unsigned variant, const core::Picture* picture) {
        if (picture != nullptr) {
            auto model = readModel(folderOf(*picture), *picture, form.length_m, form.beam_m);
            if (model) {
                form.lights = model->lights;
                return {std::move(form), std::move(model->shape)};
            }
            remark(name, model.error());
        }
        ShipShape shape = shapeOf(form, variant);
        return {std::move(form), std::move(shape)};
    }
    void remark(const std::string& name, const std::string& what) {
        m_fleet.remarks.push_back(name + " is drawn without a model: " + what);
    }

private:
    fs::path folderOf(const core::Picture& picture) const {
        std::error_code ignored;
        const bool own = !m_ownModels.empty() && !fs::exists(m_assets / "models" / picture.model, ignored) &&
                         fs::exists(m_ownModels / picture.model, ignored);
        return own ? m_ownModels : m_assets / "models";
    }

    fs::path m_assets;
    fs::path m_ownModels;
    Fleet& m_fleet;
};

}  // namespace

ShipLook lookOfAdded(const core::TargetLayout& target, std::size_t index) {
    ShipForm form = formOf(target);
    ShipShape shape = shapeOf(form, static_cast<unsigned>(index));
    return {std::move(form), std::move(shape)};
}

bool looksLike(const core::TargetLayout& a, const core::TargetLayout& b) {
    return a.type == b.type && a.length_m == b.length_m && a.beam_m == b.beam_m && a.draught_m == b.draught_m;
}

Fleet fleetOf(const core::World& world, const fs::path& assets, const fs::path& ownModels) {
    Fleet fleet;
    Builder builder(assets, ownModels, fleet);
    for (const auto& ship : world.ships) {
        const core::Vessel& v = ship->vessel;
        fleet.own.push_back(builder.look(ship->id, formOf(v), 0, v.picture ? &*v.picture : nullptr));
    }
    for (std::size_t i = 0; i < world.targets.size(); ++i) {
        const core::TargetLayout& t = world.targets[i];
        std::optional<core::Picture> picture;
        if (!t.picture.empty()) {
            auto read = pictureOf(assets, t.picture);
            if (read) picture = std::move(read).value();
            if (!read) builder.remark(t.id, read.error());
        }
        fleet.targets.push_back(
            builder.look(t.id, formOf(t), static_cast<unsigned>(i), picture ? &*picture : nullptr));
    }
    return fleet;
}

}  // namespace sagara::render
