#pragma once

#include <unistd.h>

#include <map>

#include "tests/support/Assets.h"
#include "ui/vessels/VesselLibrary.h"

namespace sagara::test {

/// Vessels in memory: the two shipped ones; a scenario uses patrol51.
class FakeLibrary final : public ui::VesselLibrary {
public:
    struct Kept {
        std::string name, text;
        bool shipped = true, retired = false;
    };
    std::map<std::string, Kept> vessels;
    std::string noDatabase;
    std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("sagara-vessels-" + std::to_string(::getpid()));

    FakeLibrary() {
        vessels["patrol51"] = {"51.5 m patrol vessel", readAsset("vessels/patrol51.json")};
        vessels["esso-osaka"] = {"Esso Osaka, 278 000 dwt tanker", readAsset("vessels/esso-osaka.json")};
        std::filesystem::create_directories(folder);
    }
    ~FakeLibrary() override { std::filesystem::remove_all(folder); }

    std::vector<ui::VesselEntry> all() const override {
        std::vector<ui::VesselEntry> entries;
        for (const auto& [id, kept] : vessels) entries.push_back({id, kept.name, kept.shipped, kept.retired});
        return entries;
    }
    std::string text(const std::string& id) const override {
        const auto it = vessels.find(id);
        return it == vessels.end() ? std::string() : it->second.text;
    }
    ui::Trouble save(const std::string& id, const std::string& name, const std::string& text) override {
        vessels[id] = {name, text, false, false};
        return std::nullopt;
    }
    ui::Trouble retire(const std::string& id) override {
        vessels[id].retired = true;
        return std::nullopt;
    }
    ui::Trouble restore(const std::string& id) override {
        vessels[id].retired = false;
        return std::nullopt;
    }
    std::vector<std::string> usedBy(const std::string& id) const override {
        return id == "patrol51" ? std::vector<std::string>{"Basic Navigation"} : std::vector<std::string>{};
    }
    bool isShippedToo(const std::string& id) const override { return id == "patrol51" || id == "esso-osaka"; }
    ui::Trouble backToShipped(const std::string& id) override {
        vessels[id] = {vessels[id].name, readAsset("vessels/" + id + ".json"), true, false};
        return std::nullopt;
    }
    std::filesystem::path shippedModels() const override { return std::string(SAGARA_ASSETS) + "/models"; }
    std::filesystem::path ownModels() const override { return folder / "models"; }
    std::string trouble() const override { return noDatabase; }
};

}  // namespace sagara::test
