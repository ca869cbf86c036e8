#pragma once

#include "core/world/Activity.h"

namespace sagara::ui {

/// What a vessel sounds in restricted visibility at one moment.
struct FogSignal {
    bool horn = false;
    bool bell = false;
    bool gong = false;
    friend bool operator==(const FogSignal&, const FogSignal&) = default;
};

/// Below this vessels sound: COLREG names no figure; two miles is the usual order of masters.
inline constexpr double kRestrictedVisibility_m = 3704.0;

/// COLREG rule 35, at most one signal of each kind: (a) making way: one prolonged blast every two minutes;
/// (b) under way and stopped: two, two seconds apart; (c) not under command, restricted, sailing, fishing,
/// towing: one prolonged and two short; (g) at anchor: the bell five seconds every minute, from 100 m on the
/// gong after it. Moored vessels are silent. `at_s` is any clock; who sounds one after the other has another
/// one.
FogSignal fogSignal(core::Activity activity, bool makingWay, double length_m, double at_s);

}  // namespace sagara::ui
