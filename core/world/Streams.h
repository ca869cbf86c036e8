#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/Config.h"
#include "core/base/Grid.h"
#include "core/base/LocalFrame.h"
#include "core/base/SimTime.h"
#include "core/sea/Tide.h"

namespace sagara::core {

/// When the tide is high, in order of time, over an exercise and the tide before and after it.
struct HighWater {
    double time_s = 0.0;   ///< of the exercise
    double range_m = 0.0;  ///< its height over that of the low water after it
};
std::vector<HighWater> highWatersOf(const TidePrediction& tide, double longest_s);

/// Where a moment lies between two high waters.
struct TidalClock {
    double hour = 0.0;    ///< after the earlier high water; in 0 to 6 the tables go by it
    double before = 0.0;  ///< the same less the time between both, so negative: hours before the later
    double range_m = 0.0;
};
TidalClock tidalClockAt(const std::vector<HighWater>& highWaters, SimTime time);

/// A value for every hour from six before to six after high water.
using ByHour = std::array<double, 13>;
inline constexpr int kHighWaterHour = 6;  ///< index of high water itself

/// Streams of an area that change from place to place: what is added to the current of the weather.
/// Immutable.
class Streams {
public:
    /// A tidal diamond: set and rate by the hour at one place, as charts and tables print it.
    struct Table {
        NorthEast at;
        std::array<NorthEast, 13> springs_mps, neaps_mps;
    };
    /// Components on a raster; with `byHour` they are multiplied by the hour's value, without they are
    /// steady.
    struct Field {
        Grid north_mps, east_mps;
        std::optional<ByHour> byHour;
    };

    std::vector<Table> tables;
    std::vector<Field> fields;  ///< finest first
    double highWater_s = 0.0;   ///< the tables' high water is so much later than the area's
    double springRange_m = 0.0;
    double neapRange_m = 0.0;

    bool empty() const { return tables.empty() && fields.empty(); }
    bool isTidal() const;
    /// Where it sets at this place: of the first field that covers it, else of the tables, each by the
    /// inverse square of its distance; rates go with the range of the tide from neaps to springs and 20 %
    /// beyond.
    NorthEast at(NorthEast p, const TidalClock& clock) const;
};

/// "source", "springRange_m", "neapRange_m" and "highWaterLater_min" (with tables), "tables": "at", "springs"
/// and "neaps" of "to_deg" and "rate_kn" at the 13 hours; "fields": raster as in "depths" with "north" and
/// "east" in units of "unit" m/s and, where they are tidal, "byHour".
Streams readStreams(config::Reader& in, const LocalFrame& frame);

}  // namespace sagara::core
