#include "core/base/Config.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace sagara::core::config {
namespace {

using nlohmann::json;

/// How a value is quoted in a message: short values whole, long ones cut.
std::string quoted(const json& value) {
    if (value.is_number_float()) return formatNumber(value.get<double>());
    if (value.is_array()) return "a list of " + std::to_string(value.size());
    if (value.is_object()) return "an object";
    std::string text = value.dump();
    if (text.size() > 60) text = text.substr(0, 57) + "...";
    return text;
}

std::string describe(Range range) {
    const std::string unit = *range.unit ? std::string(" ") + range.unit : "";
    return formatNumber(range.low) + " to " + formatNumber(range.high) + unit;
}

std::string join(std::span<const char* const> names) {
    std::string all;
    for (const char* name : names) all += (all.empty() ? "" : ", ") + std::string(name);
    return all;
}

/// What a key names in an object; null when there is nothing. A key may lead on: "near.lat", "between[1]".
const json* valueAt(const json* value, std::string_view key) {
    while (value && !key.empty()) {
        if (key.front() == '[') {
            std::size_t index = 0;
            std::from_chars(key.data() + 1, key.data() + key.size(), index);
            value = value->is_array() && index < value->size() ? &(*value)[index] : nullptr;
            key.remove_prefix(key.find(']') + 1);
        } else {
            const std::string_view step = key.substr(0, key.find_first_of(".["));
            const bool there = value->is_object() && value->contains(step);
            value = there ? &*value->find(step) : nullptr;
            key.remove_prefix(step.size());
        }
        if (key.starts_with('.')) key.remove_prefix(1);
    }
    return value;
}

}  // namespace

std::string formatNumber(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

bool isId(std::string_view id) {
    return !id.empty() && id.size() <= 60 && std::all_of(id.begin(), id.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    });
}

void Node::problem(std::string found, std::string expected) const {
    m_problems->add({m_path, std::move(found), std::move(expected)});
}

std::vector<double> Node::numbers(std::size_t count, Range range) const {
    std::vector<double> list;
    if (m_json && m_json->is_array() && m_json->size() == count) {
        for (const json& item : *m_json) {
            const double number = item.is_number() ? item.get<double>() : std::nan("");
            if (number >= range.low && number <= range.high) list.push_back(number);
        }
        if (list.size() == count) return list;
    }
    if (m_json)
        problem("is " + quoted(*m_json),
                "a list of " + std::to_string(count) + " numbers from " + describe(range));
    return {};
}

Document::Document(std::string name, std::string_view text) : m_problems(std::move(name)) {
    try {
        m_json = std::make_unique<json>(json::parse(text));
    } catch (const json::exception& e) {
        const std::string what =
            e.what();  // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
        m_problems.add({"", "is not JSON (" + what.substr(what.find("] ") + 2) + ")", "a JSON object"});
    }
    if (m_json && !m_json->is_object()) {
        m_problems.add({"", "is " + quoted(*m_json), "a JSON object"});
        m_json.reset();
    }
}

Document::~Document() = default;

Node Document::root() { return {m_json.get(), "", &m_problems}; }

bool Document::isKind(std::string_view kind, int newestVersion) {
    if (!wellFormed()) return false;
    const std::size_t before = m_problems.size();
    Reader in(root());
    const std::string found = in.text("document");
    if (!found.empty() && found != kind)
        in.problem("document", "is \"" + found + "\"", "\"" + std::string(kind) + "\"");
    m_version = in.integer("version", 1, newestVersion);
    return m_problems.size() == before;
}

Reader::Reader(Node node) : m_node(std::move(node)), m_problemsBefore(m_node.m_problems->size()) {
    if (m_node.m_json && !m_node.m_json->is_object()) {
        m_node.problem("is " + quoted(*m_node.m_json), "an object");
        m_node.m_json = nullptr;
    }
}

std::string Reader::pathOf(std::string_view key) const {
    return m_node.m_path.empty() ? std::string(key) : m_node.m_path + "." + std::string(key);
}

const json* Reader::find(std::string_view key) {
    m_known.emplace(key.substr(0, key.find_first_of(".[")));
    return valueAt(m_node.m_json, key);
}

const json* Reader::require(std::string_view key, const char* expected) {
    const json* value = find(key);
    if (!value && m_node.m_json) problem(key, "is missing", expected);
    return value;
}

bool Reader::has(std::string_view key) const { return valueAt(m_node.m_json, key) != nullptr; }

void Reader::problem(std::string_view key, std::string found, std::string expected) {
    m_node.m_problems->add({pathOf(key), std::move(found), std::move(expected)});
}

double Reader::checked(const json& value, const std::string& path, Range range) {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (number >= range.low && number <= range.high) return number;  // false for NaN
    m_node.m_problems->add({path, "is " + quoted(value), describe(range)});
    return range.low;
}

double Reader::number(std::string_view key, Range range) {
    const json* value = require(key, describe(range).c_str());
    return value ? checked(*value, pathOf(key), range) : range.low;
}

double Reader::numberOr(std::string_view key, double fallback, Range range) {
    const json* value = find(key);
    return value ? checked(*value, pathOf(key), range) : fallback;
}

int Reader::integer(std::string_view key, int low, int high) {
    const std::string expected = "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
    const json* value = require(key, expected.c_str());
    if (!value) return low;
    if (value->is_number_integer()) {
        const auto number = value->get<std::int64_t>();
        if (number >= low && number <= high) return static_cast<int>(number);
    }
    problem(key, "is " + quoted(*value), expected);
    return low;
}

int Reader::integerOr(std::string_view key, int fallback, int low, int high) {
    return find(key) ? integer(key, low, high) : fallback;
}

bool Reader::flagOr(std::string_view key, bool fallback) {
    const json* value = find(key);
    if (!value) return fallback;
    if (!value->is_boolean()) problem(key, "is " + quoted(*value), "true or false");
    return value->is_boolean() ? value->get<bool>() : fallback;
}

std::string Reader::text(std::string_view key) {
    const json* value = require(key, "a text");
    if (!value) return {};
    if (value->is_string() && !value->get_ref<const std::string&>().empty()) return value->get<std::string>();
    problem(key, "is " + quoted(*value), "a text that is not empty");
    return {};
}

std::string Reader::textOr(std::string_view key, std::string fallback) {
    return find(key) ? text(key) : fallback;
}

std::string Reader::id(std::string_view key) {
    const std::string found = text(key);
    if (!found.empty() && !isId(found))
        problem(key, "is \"" + found + "\"", "1 to 60 letters a-z, digits and hyphens");
    return found;
}

GeoPoint Reader::geoPoint(std::string_view key) {
    Reader point(child(key));
    GeoPoint p{point.number("lat", {-90.0, 90.0, "deg"}), point.number("lon", {-180.0, 180.0, "deg"})};
    point.rejectUnknownKeys();
    return p;
}

std::vector<double> Reader::numbers(std::string_view key, std::size_t count, Range range) {
    const std::string expected =
        "a list of " + (count ? std::to_string(count) + " " : "") + "numbers from " + describe(range);
    const json* value = require(key, expected.c_str());
    if (!value) return std::vector<double>(count, range.low);
    if (!value->is_array() || (count && value->size() != count)) {
        problem(key, "is " + quoted(*value), expected);
        return std::vector<double>(count, range.low);
    }
    std::vector<double> list;
    list.reserve(value->size());
    for (std::size_t i = 0; i < value->size(); ++i) {
        const json& item = (*value)[i];
        const double number = item.is_number() ? item.get<double>() : std::nan("");
        if (number >= range.low && number <= range.high) {
            list.push_back(number);
        } else {  // the path is built for a problem only: these lists can be long
            list.push_back(checked(item, pathOf(key) + "[" + std::to_string(i) + "]", range));
        }
    }
    return list;
}

std::vector<std::string> Reader::texts(std::string_view key) {
    std::vector<std::string> all;
    for (const Node& node : list(key)) {
        if (!node.m_json->is_string()) {
            node.problem("is " + quoted(*node.m_json), "a text");
            continue;
        }
        all.push_back(node.m_json->get<std::string>());
    }
    return all;
}

std::vector<GeoPoint> Reader::geoPoints(std::string_view key, std::size_t atLeast) {
    std::vector<GeoPoint> points;
    const std::vector<Node> nodes = list(key);
    for (const Node& node : nodes) {
        const json& pair = *node.m_json;
        const bool valid = pair.is_array() && pair.size() == 2 && pair[0].is_number() &&
                           pair[1].is_number() && std::abs(pair[0].get<double>()) <= 90.0 &&
                           std::abs(pair[1].get<double>()) <= 180.0;
        if (!valid) node.problem("is " + quoted(pair), "[latitude, longitude] in degrees");
        if (valid) points.push_back({pair[0].get<double>(), pair[1].get<double>()});
    }
    if (has(key) && nodes.size() < atLeast) {
        problem(key, "has " + std::to_string(nodes.size()) + " points",
                "at least " + std::to_string(atLeast));
    }
    return points;
}

Node Reader::child(std::string_view key) {
    const json* value = require(key, "an object");
    return {value, pathOf(key), m_node.m_problems};
}

std::vector<Node> Reader::items(const json* array, std::string_view key) {
    std::vector<Node> nodes;
    if (array && !array->is_array()) problem(key, "is " + quoted(*array), "a list");
    if (!array || !array->is_array()) return nodes;
    for (std::size_t i = 0; i < array->size(); ++i) {
        nodes.push_back({&(*array)[i], pathOf(key) + "[" + std::to_string(i) + "]", m_node.m_problems});
    }
    return nodes;
}

std::vector<Node> Reader::list(std::string_view key) { return items(require(key, "a list"), key); }

std::vector<Node> Reader::listOr(std::string_view key) { return items(find(key), key); }

std::size_t Reader::choiceIndex(std::string_view key, std::span<const char* const> names) {
    const json* value = require(key, ("one of " + join(names)).c_str());
    if (!value) return names.size();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (*value == names[i]) return i;
    }
    problem(key, "is " + quoted(*value), "one of " + join(names));
    return names.size();
}

bool Reader::sound() const { return m_node.m_problems->size() == m_problemsBefore; }

void Reader::rejectUnknownKeys() {
    if (!m_node.m_json) return;
    for (const auto& [key, value] : m_node.m_json->items()) {
        if (m_known.contains(key)) continue;
        std::string known;
        for (const std::string& name : m_known) known += (known.empty() ? "" : ", ") + name;
        problem(key, "is unknown", "one of " + known);
    }
}

}  // namespace sagara::core::config
