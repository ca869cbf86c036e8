#include "ui/editor/Json.h"

#include <charconv>
#include <variant>
#include <vector>

namespace sagara::ui::editor {
namespace {

using Step = std::variant<std::string, std::size_t>;

std::vector<Step> stepsOf(const std::string& path) {
    std::vector<Step> steps;
    std::size_t at = 0;
    while (at < path.size()) {
        if (path[at] == '.') {
            ++at;
        } else if (path[at] == '[') {
            std::size_t index = 0;
            std::from_chars(path.data() + at + 1, path.data() + path.size(), index);
            steps.emplace_back(index);
            at = std::min(path.find(']', at), path.size() - 1) + 1;
        } else {
            const std::size_t end = std::min(path.find_first_of(".[", at), path.size());
            steps.emplace_back(path.substr(at, end - at));
            at = end;
        }
    }
    return steps;
}

Json* stepInto(Json* value, const Step& step, bool make) {
    if (const auto* index = std::get_if<std::size_t>(&step))
        return value->is_array() && *index < value->size() ? &(*value)[*index] : nullptr;
    const auto& key = std::get<std::string>(step);
    if (make && !value->is_object()) *value = Json::object();
    if (!value->is_object()) return nullptr;
    if (make) return &(*value)[key];
    const auto it = value->find(key);
    return it == value->end() ? nullptr : &*it;
}

}  // namespace

std::string join(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "." + key;
}

std::string join(const std::string& path, std::size_t index) {
    return path + "[" + std::to_string(index) + "]";
}

std::string parentOf(const std::string& path) {
    const std::size_t at = path.find_last_of(".[");
    return at == std::string::npos ? std::string() : path.substr(0, at);
}

std::size_t indexOf(const std::string& path) {
    std::size_t index = 0;
    const std::size_t at = path.rfind('[');
    if (at != std::string::npos) std::from_chars(path.data() + at + 1, path.data() + path.size(), index);
    return index;
}

bool within(const std::string& path, const std::string& outer) {
    if (outer.empty()) return true;
    return path.starts_with(outer) &&
           (path.size() == outer.size() || path[outer.size()] == '.' || path[outer.size()] == '[');
}

const Json* find(const Json& document, const std::string& path) {
    auto* at = const_cast<Json*>(&document);  // never written without `make`
    for (const Step& step : stepsOf(path)) {
        if (at) at = stepInto(at, step, false);
    }
    return at;
}

void put(Json& document, const std::string& path, Json value) {
    Json* at = &document;
    for (const Step& step : stepsOf(path)) {
        at = stepInto(at, step, true);
        if (!at) return;
    }
    *at = std::move(value);
}

void erase(Json& document, const std::string& path) {
    const std::vector<Step> steps = stepsOf(path);
    Json* at = &document;
    for (std::size_t i = 0; i + 1 < steps.size() && at; ++i) at = stepInto(at, steps[i], false);
    if (!at || steps.empty()) return;
    if (const auto* index = std::get_if<std::size_t>(&steps.back())) {
        if (at->is_array() && *index < at->size()) at->erase(*index);
    } else if (at->is_object()) {
        at->erase(std::get<std::string>(steps.back()));
    }
}

double numberAt(const Json& document, const std::string& path, double fallback) {
    const Json* value = find(document, path);
    return value && value->is_number() ? value->get<double>() : fallback;
}

std::string textAt(const Json& document, const std::string& path, const std::string& fallback) {
    const Json* value = find(document, path);
    return value && value->is_string() ? value->get<std::string>() : fallback;
}

std::size_t sizeAt(const Json& document, const std::string& path) {
    const Json* value = find(document, path);
    return value && value->is_array() ? value->size() : 0;
}

}  // namespace sagara::ui::editor
