#include "render/scene/light/SignalMast.h"

#include <algorithm>

namespace sagara::render {
namespace {

/// Where the picture of the ship has that light.
void take(const ShipForm& f, core::LightPlace place, double& x_m, double& up_m) {
    if (const auto& p = f.lights[static_cast<std::size_t>(place)]) x_m = p->x, up_m = p->up;
}

}  // namespace

SignalMast signalMastOf(const ShipForm& f) {
    // Annex I, 2(a): the forward light at least the beam above the hull, between 6 and 12 m; 2(c): 2.5 m
    // under 20 m. Over the bridge in any case.
    const double least_m = f.length_m >= 20.0 ? std::clamp(f.beam_m, 6.0, 12.0) : 2.5;
    const double foreLeast_m = f.freeboard_m + least_m;
    const double first_m = std::max(f.bridgeHeight_m + 2.0, f.freeboard_m + std::clamp(f.beam_m, 2.5, 12.0));
    SignalMast m;
    m.two = f.length_m >= 50.0;
    m.spacing_m = f.length_m >= 20.0 ? 2.0 : 1.0;  // annex I, 2(i)
    if (m.two && f.bridge_m < 0.0) {
        m.fore_m = 0.42 * f.length_m;
        m.foreUp_m = std::max(first_m - 2.0, foreLeast_m);
        m.main_m = f.bridge_m - 0.04 * f.length_m;
    } else if (m.two) {
        m.fore_m = f.bridge_m + 0.01 * f.length_m;
        m.foreUp_m = std::max(first_m, foreLeast_m);
        m.main_m = -0.12 * f.length_m;
    } else {
        // A yacht's on her mast.
        m.fore_m = f.style == ShipStyle::Yacht ? 0.08 * f.length_m : f.bridge_m;
        m.foreUp_m = std::max(first_m, foreLeast_m);
        m.main_m = m.fore_m;
    }
    // 2(a): the after one 4.5 m above the forward one.
    m.mainUp_m = m.two ? std::max(first_m, m.foreUp_m) + 4.5 : m.foreUp_m;
    take(f, core::LightPlace::MastheadForward, m.fore_m, m.foreUp_m);
    take(f, m.two ? core::LightPlace::MastheadAft : core::LightPlace::MastheadForward, m.main_m, m.mainUp_m);
    // 2(g): not above three quarters of the forward masthead light; 2(j): a fishing vessel's two spacings
    // below the lower of her two all-round lights.
    double side_m = std::min(f.bridgeHeight_m, 0.75 * m.foreUp_m);
    if (f.style == ShipStyle::Fishing) side_m = std::min(side_m, m.foreUp_m - 3.0 * m.spacing_m);
    m.sideUp_m = std::max(f.freeboard_m + 0.8, side_m);
    m.anchor_m = 0.38 * f.length_m;
    const double deck_m = f.deckAt_m(m.anchor_m);
    // 2(k): from 50 m at least 6 m above the hull.
    m.anchorUp_m =
        deck_m + (m.two ? std::clamp(0.1 * f.length_m, 6.0, 12.0) : std::max(2.5, 0.1 * f.length_m));
    take(f, core::LightPlace::AnchorForward, m.anchor_m, m.anchorUp_m);
    return m;
}

}  // namespace sagara::render
