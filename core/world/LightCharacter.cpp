#include "core/world/LightCharacter.h"

#include <cmath>
#include <cstdlib>
#include <string>

namespace sagara::core {
namespace {

std::vector<std::string> words(std::string_view text) {
    std::vector<std::string> out;
    std::string word;
    for (const char c : text) {
        if (c != ' ') {
            word += c;
        } else if (!word.empty()) {
            out.push_back(std::move(word));
            word.clear();
        }
    }
    if (!word.empty()) out.push_back(word);
    return out;
}

std::optional<std::array<double, 3>> colourOf(const std::string& word) {
    if (word == "W") return std::array{1.0, 0.95, 0.82};
    if (word == "R") return std::array{1.0, 0.13, 0.08};
    if (word == "G") return std::array{0.12, 1.0, 0.42};
    if (word == "Y") return std::array{1.0, 0.78, 0.12};
    return std::nullopt;
}

/// Kind of light and how many flashes: "Fl(2)" is {"Fl", 2}.
struct Kind {
    std::string name;
    int count = 1;
};
std::optional<Kind> kindOf(const std::string& word) {
    const std::size_t open = word.find('(');
    if (open == std::string::npos) return Kind{word, 1};
    if (word.back() != ')' || open == 0) return std::nullopt;
    const std::string inside = word.substr(open + 1, word.size() - open - 2);
    if (word.compare(0, open, "Mo") == 0) return inside == "A" ? std::optional(Kind{"Mo", 1}) : std::nullopt;
    const int count = std::atoi(inside.c_str());
    if (count < 1 || count > 12) return std::nullopt;
    return Kind{word.substr(0, open), count};
}

/// Length of a flash and time from one to the next within a group, seconds.
struct Rhythm {
    double flash_s;
    double every_s;
};
std::optional<Rhythm> rhythmOf(const std::string& name) {
    if (name == "Fl") return Rhythm{0.5, 2.0};
    if (name == "LFl") return Rhythm{2.0, 4.0};
    if (name == "Q") return Rhythm{0.35, 1.0};
    if (name == "VQ") return Rhythm{0.2, 0.5};
    return std::nullopt;
}

}  // namespace

std::optional<LightCharacter> LightCharacter::parse(std::string_view text) {
    const std::vector<std::string> parts = words(text);
    if (parts.size() < 2 || parts.size() > 3) return std::nullopt;
    LightCharacter light;
    const auto colour = colourOf(parts[1]);
    if (!colour) return std::nullopt;
    light.m_colour = *colour;
    double period_s = 0.0;
    if (parts.size() == 3) {
        char* end = nullptr;
        period_s = std::strtod(parts[2].c_str(), &end);
        if (std::string_view(end) != "s" || !(period_s > 0.0) || period_s > 120.0) return std::nullopt;
    }
    const auto flash = [&](double from_s, double length_s) {
        light.m_flashes.push_back({std::llround(1e6 * from_s), std::llround(1e6 * (from_s + length_s))});
    };
    double used_s = 0.0;  ///< end of the last flash and the dark after it
    std::string kinds = parts[0];
    while (!kinds.empty()) {
        const std::size_t plus = kinds.find('+');
        const auto kind = kindOf(kinds.substr(0, plus));
        kinds = plus == std::string::npos ? "" : kinds.substr(plus + 1);
        if (!kind) return std::nullopt;
        if (kind->name == "F") {
            period_s = 1.0;
            flash(0.0, 1.0);
        } else if (kind->name == "Iso" && period_s > 0.0) {
            flash(0.0, 0.5 * period_s);
        } else if (kind->name == "Oc" && period_s > 0.0) {
            flash(0.0, period_s - std::min(2.0, 0.3 * period_s));
        } else if (kind->name == "Mo") {
            flash(0.0, 0.5);
            flash(1.0, 1.5);
            used_s = 3.0;
        } else if (const auto rhythm = rhythmOf(kind->name)) {
            for (int i = 0; i < kind->count; ++i, used_s += rhythm->every_s) flash(used_s, rhythm->flash_s);
        } else {
            return std::nullopt;
        }
    }
    if (period_s <= 0.0) period_s = used_s;  // quick lights need no period
    light.m_period_us = std::llround(1e6 * period_s);
    if (light.m_period_us <= 0 || light.m_flashes.back().to_us > light.m_period_us) return std::nullopt;
    return light;
}

bool LightCharacter::lit(core::SimTime time) const {
    std::int64_t phase_us = time.us % m_period_us;
    if (phase_us < 0) phase_us += m_period_us;
    for (const Flash& flash : m_flashes)
        if (phase_us >= flash.from_us && phase_us < flash.to_us) return true;
    return false;
}

}  // namespace sagara::core
