#pragma once

#include <string>
#include <vector>

#include "core/exercise/Snapshot.h"

namespace sagara::ui {

/// What the own ship's sensors say, for instruments connected by NMEA 0183: HDT, ROT, VHW, VTG, GGA, GLL,
/// ZDA, DBT, DPT, MWV (apparent and true), RSA, RPM of every shaft. With checksums, without line ends. Status
/// and mode are those of a valid fix, since ordinary instruments refuse simulated ones. Depth is of a
/// transducer in the keel.
std::vector<std::string> nmeaReports(const core::World& world, const core::Snapshot& now,
                                     std::size_t ship = 0);

/// Wind over the deck: where it comes from relative to the bow, and its speed.
struct ApparentWind {
    double from_rad = 0.0;  ///< 0 to 2 pi, clockwise from the bow
    double speed_mps = 0.0;
};
ApparentWind apparentWind(const core::WindVelocity& wind, const core::OwnShipView& ship);

}  // namespace sagara::ui
