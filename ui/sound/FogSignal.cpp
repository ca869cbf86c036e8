#include "ui/sound/FogSignal.h"

#include <cmath>

namespace sagara::ui {
namespace {

constexpr double kProlonged_s = 5.0;  ///< rule 32(c): four to six
constexpr double kShort_s = 1.0;      ///< rule 32(b)
constexpr double kBetween_s = 2.0;
constexpr double kBell_s = 5.0;

bool within(double at_s, double from_s, double length_s) {
    return at_s >= from_s && at_s < from_s + length_s;
}

}  // namespace

FogSignal fogSignal(core::Activity activity, bool makingWay, double length_m, double at_s) {
    using enum core::Activity;
    FogSignal signal;
    if (activity == Moored) return signal;
    if (activity == Anchored) {
        const double t = at_s - 60.0 * std::floor(at_s / 60.0);
        signal.bell = t < kBell_s;
        signal.gong = length_m >= 100.0 && within(t, kBell_s, kBell_s);
        return signal;
    }
    const double t = at_s - 120.0 * std::floor(at_s / 120.0);
    signal.horn = t < kProlonged_s;
    if (activity != UnderWay) {
        const double second_s = kProlonged_s + kBetween_s;
        signal.horn = signal.horn || within(t, second_s, kShort_s) ||
                      within(t, second_s + kShort_s + kBetween_s, kShort_s);
    } else if (!makingWay) {
        signal.horn = signal.horn || within(t, kProlonged_s + kBetween_s, kProlonged_s);
    }
    return signal;
}

}  // namespace sagara::ui
