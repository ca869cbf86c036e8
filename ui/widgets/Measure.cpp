#include "ui/widgets/Measure.h"

#include "core/base/Angle.h"

namespace sagara::ui {

RangeBearing measure(const core::LocalFrame& frame, core::NorthEast from, core::NorthEast to) {
    const core::NorthEast there = core::LocalFrame(frame.toGeo(from)).toLocal(frame.toGeo(to));
    return {core::length(there), core::wrapTwoPi(core::bearing_rad({}, there))};
}

double trueDirection_rad(const core::LocalFrame& frame, core::NorthEast at, double direction_rad) {
    return core::wrapTwoPi(direction_rad - frame.convergence_rad(at));
}

}  // namespace sagara::ui
