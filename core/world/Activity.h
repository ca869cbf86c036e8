#pragma once

#include <cstdint>

namespace sagara::core {

/// What a vessel is doing as the collision regulations see it: her lights and shapes, and who keeps clear of
/// whom. Values travel on the wire: new ones to the end.
enum class Activity : std::uint8_t {
    UnderWay,         ///< power-driven, nothing special
    Anchored,         ///< rule 30
    Fishing,          ///< other than trawling, rule 26(c)
    Trawling,         ///< rule 26(b)
    Towing,           ///< the tow no longer than 200 m, rule 24(a)
    NotUnderCommand,  ///< rule 27(a)
    Restricted,       ///< in her ability to manoeuvre, rule 27(b)
    Moored,           ///< made fast to the shore
    Sailing           ///< under sail alone, rule 25
};
inline constexpr Activity kLastActivity = Activity::Sailing;
/// As documents say it: "underWay", "notUnderCommand", ...
const char* activityName(Activity activity);

/// Neither at anchor nor made fast: rule 3(i).
inline bool isUnderWay(Activity activity) {
    return activity != Activity::Anchored && activity != Activity::Moored;
}

}  // namespace sagara::core
