#include "tests/support/exercise/Lesson.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/support/Assets.h"

namespace sagara::test {

using nlohmann::json;

std::optional<std::string> TreeSource::find(core::DocumentKind kind, const std::string& id) const {
    try {
        switch (kind) {
            case core::DocumentKind::Vessel:
                return readAsset("vessels/" + id + ".json");
            case core::DocumentKind::Area:
                return readAsset("areas/" + id + "/area.json");
            case core::DocumentKind::Scenario:
                return readAsset("scenarios/" + id + ".json");
            case core::DocumentKind::Picture:
                return readAsset("pictures/" + id + ".json");
        }
    } catch (const std::runtime_error&) {
    }
    return std::nullopt;
}

std::string lessonText() { return readAsset("scenarios/basic-navigation.json"); }

std::string with(const std::string& text, const std::string& pointer, const std::string& value) {
    json document = json::parse(text);
    const json::json_pointer at(pointer);
    if (value.empty()) {
        json& parent = document.at(at.parent_pointer());
        if (parent.is_array()) parent.erase(std::stoul(at.back()));
        if (parent.is_object()) parent.erase(at.back());
    } else if (at.back() == "-") {
        document.at(at.parent_pointer()).push_back(json::parse(value));
    } else {
        document[at] = json::parse(value);
    }
    return document.dump();
}

std::string lessonWith(const std::string& pointer, const std::string& value) {
    return with(lessonText(), pointer, value);
}

core::ExerciseDocuments documentsOf(const std::string& scenarioText) {
    auto documents = core::collectDocuments({"lesson.json", scenarioText}, TreeSource());
    if (!documents) throw std::runtime_error(documents.error().text());
    return std::move(documents).value();
}

std::shared_ptr<const core::World> worldOf(const std::string& scenarioText, std::uint64_t seed) {
    auto world = core::buildWorld(documentsOf(scenarioText), seed);
    if (!world) throw std::runtime_error(world.error().text());
    return std::move(world).value();
}

std::shared_ptr<const core::World> lessonWorld(std::uint64_t seed) { return worldOf(lessonText(), seed); }

std::string problemsOf(const std::string& scenarioText) {
    const auto documents = core::collectDocuments({"lesson.json", scenarioText}, TreeSource());
    if (!documents) return documents.error().text();
    const auto world = core::buildWorld(*documents, 1);
    return world ? "" : world.error().text();
}

std::string openWaterScenario(int ownShips, int targets) {
    json s = json::parse(lessonText());
    for (const char* part : {"route", "events", "pilot", "traffic"}) s.erase(part);
    s["weather"]["wind"]["speed_kn"] = 19;  // Beaufort 5
    s["mission"]["tasks"] = json::array();
    s["mission"]["criteria"] = json::array();
    s["ownShips"] = json::array();
    for (int i = 0; i < ownShips; ++i) {
        s["ownShips"].push_back({{"id", "own-" + std::to_string(i)},
                                 {"name", "Own"},
                                 {"vessel", "patrol51"},
                                 {"heading_deg", 225},
                                 {"speed_kn", 12},
                                 {"at", {{"lat", 5.995 - 0.004 * i}, {"lon", 80.215}}}});
    }
    s["traffic"] = json::array();
    for (int i = 0; i < targets; ++i) {
        const double lat = 5.99 - 0.003 * (i % 5), lon = 80.19 + 0.01 * (i / 5);
        s["traffic"].push_back({{"id", "target-" + std::to_string(i)},
                                {"name", "Target"},
                                {"type", "coaster"},
                                {"behaviour", "circuit"},
                                {"length_m", 60},
                                {"beam_m", 10},
                                {"draught_m", 4},
                                {"route",
                                 {{{"at", {{"lat", lat}, {"lon", lon}}}, {"speed_kn", 9}},
                                  {{"at", {{"lat", lat - 0.01}, {"lon", lon + 0.02}}}, {"speed_kn", 9}},
                                  {{"at", {{"lat", lat - 0.02}, {"lon", lon}}}, {"speed_kn", 9}}}}});
    }
    return s.dump();
}

}  // namespace sagara::test
