#include "render/scene/light/ShipLights.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "render/scene/light/SignalMast.h"

namespace sagara::render {
namespace {

using core::kDegree_rad;
using core::LightPlace;
using Colour3 = std::array<double, 3>;

constexpr Colour3 kWhite{1.0, 0.95, 0.82};
constexpr Colour3 kRed{1.0, 0.12, 0.07};
constexpr Colour3 kGreen{0.10, 1.0, 0.42};
constexpr Colour3 kYellow{1.0, 0.78, 0.12};
constexpr double kSide_rad = 112.5 * kDegree_rad;  // rule 21(a), (b); what is left is the sternlight's, (c)
constexpr double kCutOff_rad = 3.0 * kDegree_rad;
constexpr double kDeckLight_M = 0.7;

/// Least ranges of rule 22 by length.
struct Ranges {
    double masthead_M, side_M, stern_M, allRound_M;
};
Ranges rangesOf(double length_m) {
    if (length_m >= 50.0) return {6.0, 3.0, 3.0, 3.0};
    if (length_m >= 12.0) return {length_m < 20.0 ? 3.0 : 5.0, 2.0, 2.0, 2.0};
    return {2.0, 1.0, 2.0, 2.0};
}

/// Hangs up the lights of one ship.
class Lamps {
public:
    explicit Lamps(const ShipForm& form) : f(form), m(signalMastOf(form)), m_range(rangesOf(form.length_m)) {}
    std::vector<ShipLight> take() { return std::move(m_lights); }

    void powerDriven();
    void sideAndStern() {
        sides();
        astern(0.0, kWhite);
    }
    void towing();
    void fishing(const Colour3& upper, const Colour3& lower, bool makingWay);
    void notUnderCommand(bool makingWay);
    void restricted(bool makingWay);
    void anchored();

private:
    void allRound(Point p, const Colour3& colour) {
        m_lights.push_back({p, colour, -core::kPi, core::kPi, m_range.allRound_M});
    }
    /// Where the picture of the ship has the lamp, else where it usually is.
    Point placed(LightPlace place, Point usual) const {
        return f.lights[static_cast<std::size_t>(place)].value_or(usual);
    }
    void masthead(double x, double up) {
        m_lights.push_back({{x, 0.0, up}, kWhite, -kSide_rad, kSide_rad, m_range.masthead_M});
    }
    void astern(double above_m, const Colour3& colour) {
        Point p = placed(LightPlace::Stern, {stern(), 0.0, f.deckAt_m(stern()) + 1.2});
        p.up += above_m;
        m_lights.push_back({p, colour, kSide_rad, core::kTwoPi - kSide_rad, m_range.stern_M});
    }
    void sides();
    void mastheads() {
        masthead(m.fore_m, m.foreUp_m);
        if (m.two) masthead(m.main_m, m.mainUp_m);
    }
    double stern() const { return -0.48 * f.length_m; }

    const ShipForm& f;
    SignalMast m;
    Ranges m_range;
    std::vector<ShipLight> m_lights;
};

void Lamps::sides() {
    // Sidelights stand where they are not hidden by the bow: at the bridge.
    const Point port = placed(LightPlace::Port, {f.bridge_m, -0.5 * f.beam_m, m.sideUp_m});
    const Point starboard = placed(LightPlace::Starboard, {f.bridge_m, 0.5 * f.beam_m, m.sideUp_m});
    m_lights.push_back({port, kRed, -kSide_rad, 0.0, m_range.side_M});
    m_lights.push_back({starboard, kGreen, 0.0, kSide_rad, m_range.side_M});
}

void Lamps::powerDriven() {
    if (f.length_m >= 12.0) {  // rule 23(a)
        mastheads();
        sideAndStern();
        return;
    }
    // Rule 23(d)(i): under 12 m an all-round white light and sidelights; (ii) under 7 m and 7 knots the white
    // light alone. Annex I, 2(d): 1 m above the sidelights.
    allRound({m.fore_m, 0.0, std::max(m.foreUp_m, m.sideUp_m + 1.0)}, kWhite);
    if (f.length_m < 7.0 && f.style != ShipStyle::FastCraft) return;
    sides();
}

void Lamps::towing() {
    // Rule 24(a): two masthead lights in a vertical line for a tow of up to 200 m; (d): the after one from 50
    // m; the towing light, yellow, above the sternlight.
    masthead(m.fore_m, m.foreUp_m);
    masthead(m.fore_m, m.foreUp_m + m.spacing_m);
    if (m.two) masthead(m.main_m, m.mainUp_m + m.spacing_m);
    sideAndStern();
    astern(m.spacing_m, kYellow);
}

void Lamps::fishing(const Colour3& upper, const Colour3& lower, bool makingWay) {
    // Annex I, 2(j): the lower twice the spacing above the sidelights.
    const double low = std::max(m.foreUp_m - m.spacing_m, m.sideUp_m + 2.0 * m.spacing_m);
    allRound({m.fore_m, 0.0, low + m.spacing_m}, upper);
    allRound({m.fore_m, 0.0, low}, lower);
    // Rule 26(b)(ii): trawling from 50 m a masthead light abaft and above the green one.
    if (m.two && upper == kGreen) masthead(m.main_m, std::max(m.mainUp_m, low + 2.0 * m.spacing_m));
    if (makingWay) sideAndStern();  // rule 26(b)(iii), (c)(iii)
}

void Lamps::notUnderCommand(bool makingWay) {
    // Rule 27(a)(i): two red lights in a vertical line where they can best be seen.
    allRound({m.main_m, 0.0, m.mainUp_m}, kRed);
    allRound({m.main_m, 0.0, m.mainUp_m - m.spacing_m}, kRed);
    if (makingWay) sideAndStern();  // rule 27(a)(iii)
}

void Lamps::restricted(bool makingWay) {
    // Rule 27(b)(i): red, white, red; annex I, 2(f)(ii): above the after masthead light.
    const std::array<Colour3, 3> upwards{kRed, kWhite, kRed};
    for (std::size_t i = 0; i < upwards.size(); ++i)
        allRound({m.main_m, 0.0, m.mainUp_m + m.spacing_m * static_cast<double>(i + 1)}, upwards[i]);
    if (!makingWay) return;  // rule 27(b)(iii)
    mastheads();
    sideAndStern();
}

void Lamps::anchored() {
    if (f.length_m < 7.0) return;  // rule 30(e)
    allRound({m.anchor_m, 0.0, m.anchorUp_m}, kWhite);
    if (f.length_m < 50.0) return;  // rule 30(b)
    // Rule 30(a)(ii); annex I, 2(k): 4.5 m below the forward one.
    const Point aft{stern(), 0.0, std::min(f.deckAt_m(stern()) + 3.0, m.anchorUp_m - 4.5)};
    allRound(placed(LightPlace::AnchorAft, aft), kWhite);
    if (f.length_m < 100.0) return;
    for (const double share : {-0.36, -0.18, 0.0, 0.18, 0.36}) {  // rule 30(c): her decks are lit
        const double x = share * f.length_m;
        m_lights.push_back({{x, 0.0, f.deckAt_m(x) + 5.0}, kWhite, -core::kPi, core::kPi, kDeckLight_M});
    }
}

}  // namespace

double ShipLight::seenFrom(double bearing_rad) const {
    const double half = 0.5 * (to_rad - from_rad), middle = 0.5 * (from_rad + to_rad);
    const double outside = std::abs(core::wrapPi(bearing_rad - middle)) - half;
    return std::clamp(1.0 - outside / kCutOff_rad, 0.0, 1.0);
}

std::vector<ShipLight> lightsOf(const ShipForm& form, core::Activity activity, bool makingWay) {
    using enum core::Activity;
    Lamps lamps(form);
    // Rule 27(g): what is under 12 m need not show that she is hampered.
    const bool hampered = activity == NotUnderCommand || activity == Restricted;
    switch (hampered && form.length_m < 12.0 ? UnderWay : activity) {
        case UnderWay:
            lamps.powerDriven();
            break;
        case Anchored:
            lamps.anchored();
            break;
        case Fishing:
            lamps.fishing(kRed, kWhite, makingWay);
            break;
        case Trawling:
            lamps.fishing(kGreen, kWhite, makingWay);
            break;
        case Towing:
            lamps.towing();
            break;
        case NotUnderCommand:
            lamps.notUnderCommand(makingWay);
            break;
        case Restricted:
            lamps.restricted(makingWay);
            break;
        case Moored:
            break;
        case Sailing:
            lamps.sideAndStern();  // rule 25(a)
            break;
    }
    return lamps.take();
}

}  // namespace sagara::render
