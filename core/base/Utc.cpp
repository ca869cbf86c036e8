#include "core/base/Utc.h"

#include <chrono>
#include <cstdio>

namespace sagara::core {
namespace {

constexpr std::int64_t kJ2000_unix_s = 946'728'000;

/// All characters of text as a number, or nothing.
std::optional<unsigned> digits(std::string_view text) {
    unsigned value = 0;
    for (const char c : text) {
        if (c < '0' || c > '9') return std::nullopt;
        value = value * 10 + static_cast<unsigned>(c - '0');
    }
    return value;
}

std::string format(std::int64_t unix_s, char between, const char* end) {
    using namespace std::chrono;
    const sys_seconds instant{seconds(unix_s)};
    const sys_days day = floor<days>(instant);
    const year_month_day date(day);
    const hh_mm_ss time(instant - day);
    char text[48];
    std::snprintf(text, sizeof text, "%04d-%02u-%02u%c%02d:%02d:%02d%s", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), between,
                  static_cast<int>(time.hours().count()), static_cast<int>(time.minutes().count()),
                  static_cast<int>(time.seconds().count()), end);
    return text;
}

}  // namespace

double daysSinceJ2000(Utc instant) { return static_cast<double>(instant.unix_s - kJ2000_unix_s) / 86'400.0; }

std::optional<Utc> parseUtc(std::string_view text) {
    using namespace std::chrono;
    if (text.size() != 20 || text[4] != '-' || text[7] != '-' || text[10] != 'T' || text[13] != ':' ||
        text[16] != ':' || text[19] != 'Z') {
        return std::nullopt;
    }
    const auto y = digits(text.substr(0, 4)), mo = digits(text.substr(5, 2)), d = digits(text.substr(8, 2));
    const auto h = digits(text.substr(11, 2)), mi = digits(text.substr(14, 2)),
               s = digits(text.substr(17, 2));
    if (!y || !mo || !d || !h || !mi || !s || *h > 23 || *mi > 59 || *s > 59) return std::nullopt;
    const year_month_day date{year(static_cast<int>(*y)), month(*mo), day(*d)};
    if (!date.ok()) return std::nullopt;
    return Utc{(sys_days(date).time_since_epoch() / days(1)) * std::int64_t{86'400} + *h * 3600 + *mi * 60 +
               *s};
}

std::string formatUtc(Utc instant) { return format(instant.unix_s, 'T', "Z"); }

std::string formatLocal(Utc instant, int utcOffset_min) {
    return format(instant.unix_s + utcOffset_min * 60, ' ', "");
}

}  // namespace sagara::core
