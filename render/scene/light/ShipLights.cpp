#include "render/scene/light/ShipLights.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"

namespace sagara::render {
namespace {

using core::kDegree_rad;
using core::LightPlace;

constexpr std::array<double, 3> kWhite{1.0, 0.95, 0.82};
constexpr std::array<double, 3> kRed{1.0, 0.12, 0.07};
constexpr std::array<double, 3> kGreen{0.10, 1.0, 0.42};
constexpr double kSide_rad = 112.5 * kDegree_rad;
constexpr double kCutOff_rad = 3.0 * kDegree_rad;

/// Least ranges of rule 22 by length.
struct Ranges {
    double masthead_M, side_M, stern_M, anchor_M;
};
Ranges rangesOf(double length_m) {
    if (length_m >= 50.0) return {6.0, 3.0, 3.0, 3.0};
    if (length_m >= 12.0) return {length_m < 20.0 ? 3.0 : 5.0, 2.0, 2.0, 2.0};
    return {2.0, 1.0, 2.0, 2.0};
}

}  // namespace

double ShipLight::seenFrom(double bearing_rad) const {
    const double half = 0.5 * (to_rad - from_rad), middle = 0.5 * (from_rad + to_rad);
    const double outside = std::abs(core::wrapPi(bearing_rad - middle)) - half;
    return std::clamp(1.0 - outside / kCutOff_rad, 0.0, 1.0);
}

std::vector<ShipLight> lightsOf(const ShipForm& f, ShipActivity activity) {
    const Ranges range = rangesOf(f.length_m);
    std::vector<ShipLight> lights;
    const double bow = 0.46 * f.length_m, stern = -0.48 * f.length_m;
    const bool large = f.length_m >= 50.0;
    const auto placed = [&](core::LightPlace place) { return f.lights[static_cast<std::size_t>(place)]; };
    const auto allRound = [&](core::LightPlace place, Point usual) {
        const Point p = placed(place).value_or(usual);
        lights.push_back({p, kWhite, -core::kPi, core::kPi, range.anchor_M});
    };
    if (activity == ShipActivity::Moored) return lights;
    if (activity == ShipActivity::Anchored) {
        allRound(LightPlace::AnchorForward, {bow, 0.0, f.deckAt_m(bow) + (large ? 6.0 : 2.5)});
        if (large) allRound(LightPlace::AnchorAft, {stern, 0.0, f.deckAt_m(stern) + 3.0});
        return lights;
    }
    // Heights above the hull of annex I: at least the beam or 6 m; the second 4.5 m above the first.
    const double first = std::max(f.bridgeHeight_m + 2.0, f.freeboard_m + std::clamp(f.beam_m, 2.5, 12.0));
    const auto masthead = [&](Point p) {
        lights.push_back({p, kWhite, -kSide_rad, kSide_rad, range.masthead_M});
    };
    const auto fore = placed(LightPlace::MastheadForward), aft = placed(LightPlace::MastheadAft);
    if (fore || aft) {
        if (fore) masthead(*fore);
        if (aft) masthead(*aft);
    } else if (f.style == ShipStyle::Yacht) {
        // Rule 25: sidelights and sternlight.
    } else if (large && f.bridge_m < 0.0) {
        masthead({0.42 * f.length_m, 0.0, first - 2.0});
        masthead({f.bridge_m - 0.04 * f.length_m, 0.0, first + 4.5});
    } else if (large) {
        masthead({f.bridge_m + 0.01 * f.length_m, 0.0, first});
        masthead({-0.12 * f.length_m, 0.0, first + 4.5});
    } else {
        masthead({f.bridge_m, 0.0, first});
    }
    const double sideUp = std::max(f.freeboard_m + 0.8, std::min(f.bridgeHeight_m, 0.75 * first));
    const Point side{f.bridge_m, 0.5 * f.beam_m, sideUp}, other{side.x, -side.y, side.up};
    const Point low{stern, 0.0, f.deckAt_m(stern) + 1.2};
    lights.push_back({placed(LightPlace::Port).value_or(other), kRed, -kSide_rad, 0.0, range.side_M});
    lights.push_back({placed(LightPlace::Starboard).value_or(side), kGreen, 0.0, kSide_rad, range.side_M});
    lights.push_back({placed(LightPlace::Stern).value_or(low), kWhite, kSide_rad, core::kTwoPi - kSide_rad,
                      range.stern_M});
    return lights;
}

}  // namespace sagara::render
