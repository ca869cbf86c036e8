#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sagara::core {

/// An instant of civil time: whole seconds since 1970-01-01T00:00:00Z, leap seconds not counted.
struct Utc {
    std::int64_t unix_s = 0;
    friend bool operator==(const Utc&, const Utc&) = default;
};

/// Days since 2000-01-01T12:00Z (J2000.0), with the fraction of the day.
double daysSinceJ2000(Utc instant);

/// "2027-01-15T03:30:00Z", the only form accepted; nothing for any other text or an impossible date.
std::optional<Utc> parseUtc(std::string_view text);
std::string formatUtc(Utc instant);
/// "2027-01-15 09:00:00" shown at a fixed offset east of Greenwich.
std::string formatLocal(Utc instant, int utcOffset_min);

}  // namespace sagara::core
