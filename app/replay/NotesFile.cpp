#include "app/replay/NotesFile.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/files/Files.h"

namespace sagara::replay {
namespace {

using Json = nlohmann::ordered_json;

/// Null: not a file of notes.
Json parsed(const std::string& text) {
    Json json = Json::parse(text, nullptr, false);
    const bool sound = json.is_object() && json.value("document", Json()) == "notes" &&
                       json.value("version", Json()) == 1 && json.contains("notes") &&
                       json["notes"].is_array();
    return sound ? json : Json();
}

}  // namespace

NotesFile::NotesFile(const std::filesystem::path& recording) : m_path(recording) { m_path += ".notes.json"; }

std::vector<ui::DebriefNote> NotesFile::read() const {
    std::vector<ui::DebriefNote> notes;
    const auto text = files::readTextFile(m_path);
    const Json json = text ? parsed(*text) : Json();
    if (json.is_null()) return notes;
    for (const Json& n : json["notes"]) {
        if (!n.is_object() || !n.contains("time_s") || !n["time_s"].is_number() || !n.contains("text") ||
            !n["text"].is_string())
            continue;
        notes.push_back({{std::llround(1e6 * std::clamp(n["time_s"].get<double>(), 0.0, 1e7))},
                         n["text"].get<std::string>()});
    }
    std::stable_sort(notes.begin(), notes.end(),
                     [](const auto& a, const auto& b) { return a.time < b.time; });
    return notes;
}

std::optional<std::string> NotesFile::add(const ui::DebriefNote& note) const {
    Json json{{"document", "notes"}, {"version", 1}, {"notes", Json::array()}};
    if (std::filesystem::exists(m_path)) {
        const auto text = files::readTextFile(m_path);
        if (!text) return text.error().message;
        json = parsed(*text);
        if (json.is_null())
            return m_path.string() + ": is not a file of notes (document \"notes\", version 1)";
    }
    json["notes"].push_back({{"time_s", note.time.seconds()}, {"text", note.text}});
    if (const auto error =
            files::writeTextFile(m_path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"))
        return error->message;
    return std::nullopt;
}

}  // namespace sagara::replay
