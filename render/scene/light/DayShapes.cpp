#include "render/scene/light/DayShapes.h"

#include <algorithm>

#include "render/scene/light/SignalMast.h"

namespace sagara::render {
namespace {

using Kind = DayShape::Kind;

constexpr Paint kBlack{0.035, 0.035, 0.035};
constexpr Paint kHalyard{0.25, 0.24, 0.22};
constexpr int kSides = 8;

/// Annex I, 6(a) and (c): 0.6 m from 20 m of length, more where there is room to see it; boats carry less.
double diameter_m(const ShipForm& f) {
    return f.length_m < 20.0 ? 0.4 : std::clamp(0.01 * f.length_m, 0.6, 1.2);
}
/// Between two shapes: 1.5 m from 20 m of length, annex I, 6(b).
double gap_m(const ShipForm& f) { return f.length_m < 20.0 ? 0.4 : 1.5; }

/// Hoisted above each other on the starboard side of the signal mast, clear of the wheelhouse.
DayHoist hoisted(const ShipForm& f, std::initializer_list<Kind> fromTop, double gap) {
    const SignalMast mast = signalMastOf(f);
    const double aside_m = std::clamp(0.2 * f.beam_m, 0.5, 3.0);
    std::vector<DayShape> shapes;
    for (const Kind kind : fromTop) shapes.push_back({kind, {mast.main_m, aside_m, 0.0}, diameter_m(f)});
    const double roof_m = std::max(f.bridgeHeight_m, f.deckAt_m(mast.main_m)) + 0.3;
    double up = roof_m + 1.2;
    for (auto shape = shapes.rbegin(); shape != shapes.rend(); ++shape) {
        shape->centre.up = up + 0.5 * shape->height_m();
        up += shape->height_m() + gap;
    }
    return {std::move(shapes), roof_m, up - gap + 0.3};
}

void cone(Solid& s, double base, double apex, double radius) {
    const double low = std::min(base, apex), high = std::max(base, apex);
    const bool up = apex > base;
    s.turned(
        {}, std::array<Solid::Ring, 2>{{{low, up ? radius : 0.0, kBlack}, {high, up ? 0.0 : radius, kBlack}}},
        kSides);
}

void shapeAt(Solid& s, const DayShape& shape, double up) {
    const double r = 0.5 * shape.diameter_m, h = 0.5 * shape.height_m();
    switch (shape.kind) {
        case Kind::Ball:
            return s.turned({},
                            std::array<Solid::Ring, 5>{{{up - r, 0.0, kBlack},
                                                        {up - 0.6 * r, 0.8 * r, kBlack},
                                                        {up, r, kBlack},
                                                        {up + 0.6 * r, 0.8 * r, kBlack},
                                                        {up + r, 0.0, kBlack}}},
                            kSides);
        case Kind::ConeUp:
            return cone(s, up - h, up + h, r);
        case Kind::ConeDown:
            return cone(s, up + h, up - h, r);
        case Kind::Diamond:
            cone(s, up, up + h, r);
            return cone(s, up, up - h, r);
    }
}

}  // namespace

DayHoist dayHoistOf(const ShipForm& f, core::Activity activity) {
    using enum core::Activity;
    switch (activity) {
        case Anchored: {
            if (f.length_m < 7.0) return {};  // rule 30(e)
            // Rule 30(a)(i): a ball in the fore part; below the anchor light.
            const SignalMast mast = signalMastOf(f);
            const Point centre{mast.anchor_m, 0.0, mast.anchorUp_m - 1.2 * diameter_m(f)};
            return {{{Kind::Ball, centre, diameter_m(f)}}, f.deckAt_m(mast.anchor_m), mast.anchorUp_m};
        }
        case Fishing:
        case Trawling:  // rule 26(b)(i), (c)(i): two cones, apexes together
            return hoisted(f, {Kind::ConeDown, Kind::ConeUp}, 0.0);
        case NotUnderCommand:
            if (f.length_m < 12.0) return {};                       // rule 27(g)
            return hoisted(f, {Kind::Ball, Kind::Ball}, gap_m(f));  // rule 27(a)(ii)
        case Restricted:
            if (f.length_m < 12.0) return {};
            return hoisted(f, {Kind::Ball, Kind::Diamond, Kind::Ball}, gap_m(f));  // rule 27(b)(ii)
        case UnderWay:
        case Towing:  // rule 24(a)(v): a diamond only for a tow longer than 200 m
        case Moored:
        case Sailing:
            return {};
    }
    return {};
}

Solid solidOf(const DayHoist& hoist) {
    Solid s;
    if (hoist.shapes.empty()) return s;
    const double origin = hoist.shapes.back().centre.up;
    for (const DayShape& shape : hoist.shapes) shapeAt(s, shape, shape.centre.up - origin);
    s.bar({0.0, 0.0, hoist.footUp_m - origin}, {0.0, 0.0, hoist.headUp_m - origin}, 0.025, kHalyard, 3);
    return s;
}

}  // namespace sagara::render
