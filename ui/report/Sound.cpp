#include "ui/report/Sound.h"

namespace sagara::report {

RunReport withoutBadPoints(const RunReport& report) {
    RunReport sound = report;
    std::erase_if(sound.track,
                  [](const TrackPoint& p) { return !isFinite(p.position) || !std::isfinite(p.time_s); });
    std::erase_if(sound.anchors, [](const AnchorDrop& a) { return !isFinite(a.position); });
    std::erase_if(sound.marks, [](const ChartMark& m) { return !isFinite(m.position); });
    for (OtherTrack& other : sound.others)
        std::erase_if(other.points, [](core::NorthEast p) { return !isFinite(p); });
    return sound;
}

}  // namespace sagara::report
