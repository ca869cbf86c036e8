#include "render/scene/light/MarkShape.h"

#include <array>

namespace sagara::render {
namespace {

constexpr Paint kRed{0.80, 0.10, 0.08};
constexpr Paint kGreen{0.06, 0.45, 0.20};
constexpr Paint kYellow{0.92, 0.76, 0.08};
constexpr Paint kBlack{0.07, 0.07, 0.07};
constexpr Paint kWhite{0.90, 0.90, 0.88};
constexpr Paint kOrange{0.92, 0.38, 0.10};
constexpr Paint kDark{0.20, 0.20, 0.20};

/// Colours from the waterline up, and the topmark.
struct Livery {
    std::array<Paint, 4> bands;
    enum class Top {
        None,
        Can,
        ConeUp,
        TwoUp,
        TwoDown,
        Apart,
        Together,
        Ball,
        TwoBalls,
        Cross
    } top = Top::None;
    Paint topPaint = kBlack;
};

Livery liveryOf(core::MarkKind kind, bool regionB) {
    using enum core::MarkKind;
    using Top = Livery::Top;
    const Paint port = regionB ? kGreen : kRed, starboard = regionB ? kRed : kGreen;
    switch (kind) {
        case LateralPort:
            return {{port, port, port, port}, Top::Can, port};
        case LateralStarboard:
            return {{starboard, starboard, starboard, starboard}, Top::ConeUp, starboard};
        case CardinalNorth:
            return {{kYellow, kYellow, kBlack, kBlack}, Top::TwoUp};
        case CardinalEast:
            return {{kBlack, kYellow, kYellow, kBlack}, Top::Apart};
        case CardinalSouth:
            return {{kBlack, kBlack, kYellow, kYellow}, Top::TwoDown};
        case CardinalWest:
            return {{kYellow, kBlack, kBlack, kYellow}, Top::Together};
        case IsolatedDanger:
            return {{kBlack, kRed, kRed, kBlack}, Top::TwoBalls};
        case SafeWater:
            return {{kRed, kWhite, kRed, kWhite}, Top::Ball, kRed};
        case Special:
            return {{kYellow, kYellow, kYellow, kYellow}, Top::Cross, kYellow};
        case Lighthouse:
        case Leading:
        case Beacon:
            break;
    }
    return {{kWhite, kWhite, kWhite, kWhite}, Top::None, kWhite};
}

void cone(Solid& s, double up, double size, bool pointUp, Paint paint) {
    const double low = pointUp ? size : 0.03, high = pointUp ? 0.03 : size;
    s.turned({}, std::array<Solid::Ring, 2>{{{up, low, paint}, {up + 1.5 * size, high, paint}}}, 8);
}
void ball(Solid& s, double up, double r, Paint paint) {
    s.turned({},
             std::array<Solid::Ring, 4>{{{up, 0.3 * r, paint},
                                         {up + 0.5 * r, r, paint},
                                         {up + 1.4 * r, r, paint},
                                         {up + 2 * r, 0.3 * r, paint}}},
             8);
}

void topmark(Solid& s, const Livery& livery, double up, double size) {
    using Top = Livery::Top;
    const auto pair = [&](bool lowUp, bool highUp) {
        cone(s, up, size, lowUp, livery.topPaint);
        cone(s, up + 1.9 * size, size, highUp, livery.topPaint);
    };
    switch (livery.top) {
        case Top::None:
            return;
        case Top::Can:
            return s.turned({},
                            std::array<Solid::Ring, 2>{
                                {{up, size, livery.topPaint}, {up + 1.6 * size, size, livery.topPaint}}},
                            8);
        case Top::ConeUp:
            return cone(s, up, size, true, livery.topPaint);
        case Top::TwoUp:
            return pair(true, true);
        case Top::TwoDown:
            return pair(false, false);
        case Top::Apart:
            return pair(false, true);
        case Top::Together:
            return pair(true, false);
        case Top::Ball:
            return ball(s, up, size, livery.topPaint);
        case Top::TwoBalls:
            ball(s, up, size, livery.topPaint);
            return ball(s, up + 2.3 * size, size, livery.topPaint);
        case Top::Cross:
            s.bar({0, -size, up}, {0, size, up + 2 * size}, 0.12, livery.topPaint);
            return s.bar({0, size, up}, {0, -size, up + 2 * size}, 0.12, livery.topPaint);
    }
}

/// A pillar buoy: float, tower in bands, topmark above the lamp.
Solid buoy(const Livery& livery, double lamp) {
    Solid s;
    const auto& b = livery.bands;
    s.turned({},
             std::array<Solid::Ring, 4>{
                 {{-0.6, 1.25, b[0]}, {0.55, 1.25, b[0]}, {0.75, 0.85, b[0]}, {0.8, 0.5, b[0]}}},
             12);
    const double step = (lamp - 0.8) / 4.0;
    s.turned({},
             std::array<Solid::Ring, 5>{{{0.8, 0.55, b[0]},
                                         {0.8 + step, 0.48, b[1]},
                                         {0.8 + 2 * step, 0.41, b[2]},
                                         {0.8 + 3 * step, 0.34, b[3]},
                                         {lamp - 0.15, 0.28, b[3]}}},
             8);
    s.turned({}, std::array<Solid::Ring, 2>{{{lamp - 0.15, 0.16, kDark}, {lamp + 0.15, 0.16, kDark}}}, 6);
    topmark(s, livery, lamp + 0.35, 0.38);
    return s;
}

/// A tower on land or on a breakwater head.
Solid beacon(const Livery& livery, double lamp) {
    Solid s;
    const auto& b = livery.bands;
    const double foot = 1.0, step = (lamp - foot) / 4.0;
    s.turned({},
             std::array<Solid::Ring, 2>{{{-2.0, 2.2, {0.6, 0.6, 0.58}}, {foot + 1.2, 2.2, {0.6, 0.6, 0.58}}}},
             8);
    s.turned({},
             std::array<Solid::Ring, 5>{{{foot, 1.1, b[0]},
                                         {foot + step, 1.0, b[1]},
                                         {foot + 2 * step, 0.9, b[2]},
                                         {foot + 3 * step, 0.8, b[3]},
                                         {lamp - 0.4, 0.75, b[3]}}},
             10);
    s.turned({}, std::array<Solid::Ring, 2>{{{lamp - 0.3, 0.3, kDark}, {lamp + 0.3, 0.3, kDark}}}, 6);
    return s;
}

/// A lattice tower with a board that is seen from seaward.
Solid leading(double lamp) {
    Solid s;
    for (const double x : {-0.8, 0.8})
        for (const double y : {-0.8, 0.8}) s.bar({x, y, -2.0}, {0.3 * x, 0.3 * y, lamp}, 0.12, kWhite, 4);
    s.box({0, 0, 0.45 * lamp}, 0.15, 1.6, 0.45 * lamp, kWhite);
    s.box({0, 0, 0.45 * lamp}, 0.2, 0.4, 0.45 * lamp, kOrange);
    return s;
}

}  // namespace

double lampHeight_m(const core::Mark& mark) { return mark.light ? mark.light->height_m : 4.0; }

Solid shapeOf(const core::Mark& mark, bool regionB) {
    const double lamp = lampHeight_m(mark);
    if (mark.kind == core::MarkKind::Lighthouse) return {};  // stands among the buildings
    if (mark.kind == core::MarkKind::Leading) return leading(lamp);
    const Livery livery = liveryOf(mark.kind, regionB);
    return mark.floating ? buoy(livery, lamp) : beacon(livery, lamp);
}

}  // namespace sagara::render
