#include <charconv>
#include <cmath>
#include <set>

#include "core/base/Config.h"
#include "core/base/Units.h"
#include "core/identify/CheckSeaTrial.h"

namespace sagara::core {
namespace {

constexpr std::size_t kMostRows = 200'000;

struct ColumnName {
    const char* name;
    Channel channel;
    double unit;
    double most;  ///< size of a number, in the unit of the file
};
constexpr ColumnName kColumns[] = {
    {"time_s", Channel::Time, 1.0, 1e7},
    {"x_m", Channel::North, 1.0, 1e6},
    {"y_m", Channel::East, 1.0, 1e6},
    {"heading_deg", Channel::Heading, kDegree_rad, 36000.0},
    {"surge_mps", Channel::Surge, 1.0, 60.0},
    {"sway_mps", Channel::Sway, 1.0, 60.0},
    {"yaw_rate_degps", Channel::YawRate, kDegree_rad, 90.0},
    {"roll_deg", Channel::Roll, kDegree_rad, 90.0},
    {"rudder_deg", Channel::Rudder, kDegree_rad, 90.0},
    {"shaft_rps", Channel::Shaft, 1.0, 100.0},
    {"shaft_rpm", Channel::Shaft, kRpm_rps, 6000.0},
    {"speed_mps", Channel::Speed, 1.0, 60.0},
    {"speed_kn", Channel::Speed, kKnot_mps, 120.0},
    {"pitch_deg", Channel::Pitch, kDegree_rad, 90.0},
    {"heave_m", Channel::Heave, 1.0, 50.0},
    {"wave_m", Channel::Wave, 1.0, 50.0},
};

struct HeaderName {
    const char* name;
    std::optional<double> SeaTrial::*member;
    double unit, low, high;
};
constexpr HeaderName kHeaders[] = {
    {"approach_mps", &SeaTrial::approach_mps, 1.0, 0.0, 60.0},
    {"approach_kn", &SeaTrial::approach_mps, kKnot_mps, 0.0, 120.0},
    {"shaft_rps", &SeaTrial::shaft_rps, 1.0, -100.0, 100.0},
    {"shaft_rpm", &SeaTrial::shaft_rps, kRpm_rps, -6000.0, 6000.0},
    {"rudder_deg", &SeaTrial::rudder_rad, kDegree_rad, -90.0, 90.0},
    {"heading_deg", &SeaTrial::switch_rad, kDegree_rad, 0.1, 180.0},
    {"wave_heading_deg", &SeaTrial::waveHeading_rad, kDegree_rad, -360.0, 360.0},
};

std::string_view trimmed(std::string_view text) {
    constexpr const char* kBlank = " \t\r";
    const std::size_t from = text.find_first_not_of(kBlank);
    if (from == std::string_view::npos) return {};
    return text.substr(from, text.find_last_not_of(kBlank) - from + 1);
}

std::vector<std::string_view> split(std::string_view line, char by) {
    std::vector<std::string_view> parts;
    for (std::size_t from = 0; from <= line.size();) {
        const std::size_t end = std::min(line.find(by, from), line.size());
        parts.push_back(trimmed(line.substr(from, end - from)));
        from = end + 1;
    }
    return parts;
}

std::optional<double> numberIn(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
    return good ? std::optional(value) : std::nullopt;
}

std::string quoted(std::string_view text) {
    constexpr std::size_t kLongest = 40;
    std::string shown = "\"";
    for (const char c : text.substr(0, kLongest)) shown += c >= ' ' && c != 127 ? c : '?';
    return shown + (text.size() > kLongest ? "...\"" : "\"");
}

std::string between(double low, double high) {
    return config::formatNumber(low) + " to " + config::formatNumber(high);
}

class TrialReader {
public:
    explicit TrialReader(const std::string& name) : m_problems(name) { m_trial.name = name; }

    Result<SeaTrial, config::Problems> read(std::string_view text) {
        for (const std::string_view line : split(text, '\n')) {
            ++m_line;
            if (line.empty()) continue;
            if (line.front() == '#')
                readHeader(trimmed(line.substr(1)));
            else if (m_columns.empty())
                readNames(line);
            else
                readRow(line);
        }
        finish();
        if (!m_problems.empty()) return m_problems;
        return std::move(m_trial);
    }

private:
    void problem(std::string found, std::string expected, std::string_view what = {}) {
        constexpr std::size_t kMost = 20;  // of one file: then they repeat themselves
        if (m_problems.size() >= kMost) return;
        const std::string comma = what.empty() ? "" : ", " + std::string(what);
        m_problems.add({"line " + std::to_string(m_line) + comma, std::move(found), std::move(expected)});
    }
    void problemOfFile(std::string found, std::string expected) {
        m_problems.add({"", std::move(found), std::move(expected)});
    }

    void readHeader(std::string_view line) {
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos) return;
        const std::string_view key = trimmed(line.substr(0, colon)), value = trimmed(line.substr(colon + 1));
        if (key == "kind") return readKind(value);
        if (key == "depth_m") {
            if (const auto depth = headerNumber(key, value, 0.1, 12000.0)) m_trial.depth_m = *depth;
            return;
        }
        for (const HeaderName& h : kHeaders) {
            if (key != h.name) continue;
            if (const auto number = headerNumber(key, value, h.low, h.high))
                m_trial.*h.member = *number * h.unit;
            return;
        }
        // A name with a unit was meant to be read; anything else is for people.
        if (key.find('_') != std::string_view::npos && key.find(' ') == std::string_view::npos)
            problem(quoted(key) + " is unknown", headerNames());
    }
    void readKind(std::string_view value) {
        std::string known;
        for (std::size_t i = 0; i < kTrialKinds; ++i) {
            const auto kind = static_cast<TrialKind>(i);
            if (value == trialKindName(kind)) return m_trial.kind = kind, void(m_kindKnown = true);
            known += (i == 0 ? "" : ", ") + std::string(trialKindName(kind));
        }
        m_kindTold = true;
        problem("is " + quoted(value), known, "kind");
    }
    std::optional<double> headerNumber(std::string_view key, std::string_view value, double low,
                                       double high) {
        const auto number = numberIn(value);
        if (number && *number >= low && *number <= high) return number;
        problem("is " + quoted(value), between(low, high), key);
        return std::nullopt;
    }
    static std::string headerNames() {
        std::string names = "kind, depth_m";
        for (const HeaderName& h : kHeaders) names += std::string(", ") + h.name;
        return names;
    }

    void readNames(std::string_view line) {
        for (const std::string_view name : split(line, ',')) {
            const ColumnName* found = nullptr;
            for (const ColumnName& c : kColumns)
                if (name == c.name) found = &c;
            m_columns.push_back(found);
            if (!found)
                problem("has a column " + quoted(name), columnNames());
            else if (!m_seen.insert(found->channel).second)
                problem("has " + quoted(name) + " again", "each quantity once");
        }
    }
    static std::string columnNames() {
        std::string names;
        for (const ColumnName& c : kColumns) names += (names.empty() ? "" : ", ") + std::string(c.name);
        return names;
    }

    void readRow(std::string_view line) {
        const auto cells = split(line, ',');
        if (cells.size() != m_columns.size())
            return problem("has " + std::to_string(cells.size()) + " cells",
                           std::to_string(m_columns.size()) + " as the names of the columns");
        if (++m_rows > kMostRows) return;
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (m_columns[i]) m_trial[m_columns[i]->channel].push_back(cell(cells[i], *m_columns[i]));
    }
    double cell(std::string_view text, const ColumnName& column) {
        const auto number = numberIn(text);
        if (number && std::abs(*number) <= column.most) return *number * column.unit;
        if (!text.empty() || column.channel == Channel::Time)
            problem("is " + quoted(text), between(-column.most, column.most), column.name);
        return std::numeric_limits<double>::quiet_NaN();
    }

    void finish() {
        if (!m_kindKnown && !m_kindTold)
            problemOfFile("does not say what it is", "a line such as \"# kind: turning\"");
        if (m_columns.empty()) problemOfFile("has no names of columns", columnNames());
        if (m_rows > kMostRows)
            problemOfFile("has " + std::to_string(m_rows) + " rows", "at most " + std::to_string(kMostRows));
        if (!m_problems.empty()) return;
        checkRows();
        for (const char* what : lackingIn(m_trial))
            problemOfFile("is a trial of kind " + std::string(trialKindName(m_trial.kind)) + " without it",
                          what);
        tidy(m_trial);
    }
    void checkRows() {
        const std::size_t least =
            m_trial.kind == TrialKind::Speed || m_trial.kind == TrialKind::Spiral ? 1 : 5;
        if (m_rows < least)
            problemOfFile("has " + std::to_string(m_rows) + " rows", "at least " + std::to_string(least));
        const auto& times = m_trial[Channel::Time];
        for (std::size_t i = 1; i < times.size(); ++i)
            if (!(times[i] > times[i - 1]))
                return problemOfFile("has time_s " + config::formatNumber(times[i]) + " after " +
                                         config::formatNumber(times[i - 1]),
                                     "rising times");
        constexpr double kLongest_s = 6.0 * 3600.0;
        if (!times.empty() && times.back() - times.front() > kLongest_s)
            problemOfFile("is " + config::formatNumber(times.back() - times.front()) + " s long",
                          "at most " + config::formatNumber(kLongest_s) + " s");
    }

    config::Problems m_problems;
    SeaTrial m_trial;
    std::size_t m_line = 0, m_rows = 0;
    bool m_kindKnown = false, m_kindTold = false;
    std::vector<const ColumnName*> m_columns;  ///< null: not known
    std::set<Channel> m_seen;
};

}  // namespace

Result<SeaTrial, config::Problems> readSeaTrial(const std::string& name, std::string_view text) {
    return TrialReader(name).read(text);
}

}  // namespace sagara::core
