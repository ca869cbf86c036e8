#include "render/scene/ship/ShipShape.h"

#include <algorithm>
#include <cmath>

#include "render/scene/light/ShipLights.h"
#include "render/scene/ship/HullSurface.h"

namespace sagara::render {
namespace {

constexpr double kLow_m = 30.0;  ///< shorter hulls have waves higher than their decks

constexpr Paint kWhite{0.88, 0.88, 0.86};
constexpr Paint kGrey{0.53, 0.57, 0.61};
constexpr Paint kDarkGrey{0.20, 0.21, 0.22};
constexpr Paint kGlass{0.06, 0.08, 0.10, 0.10};
constexpr Paint kPortholes{0.10, 0.11, 0.13, 0.45};
constexpr Paint kBuff{0.78, 0.62, 0.34};
constexpr Paint kOrange{0.90, 0.36, 0.08};
constexpr Paint kSteel{0.45, 0.42, 0.38};

/// Builds one ship; x and heights in metres from the form.
class Builder {
public:
    Builder(const ShipForm& form, unsigned variant) : f(form), m_variant(variant) {}
    ShipShape build();

private:
    double L(double share) const { return share * f.length_m; }
    double B(double share) const { return share * f.beam_m; }
    double deck(double x) const { return f.deckAt_m(x); }

    /// A deckhouse from x0 to x1 with a band of windows; returns its top.
    double house(Solid& s, double x0, double x1, double halfY, double base, double height, Paint paint,
                 Paint windows, double slant = 0.0) const;
    void mast(double x, double base, double top, Paint paint, bool radar);
    void rail(double x0, double x1, double height);
    void funnel(double x, double base, double height, double size, Paint paint);
    void hull(HullPaint paint) { shape.hull.append(hullSurface(f, paint), {}); }

    void patrol();
    void fishing();
    void cargo(bool tanker, bool containers);
    void ferry();
    void yacht();
    void tug();
    void fastCraft();

    const ShipForm& f;
    unsigned m_variant;
    ShipShape shape;
};

double Builder::house(Solid& s, double x0, double x1, double halfY, double base, double height, Paint paint,
                      Paint windows, double slant) const {
    const double middle = 0.5 * (x0 + x1), halfX = 0.5 * (x1 - x0);
    s.tapered({middle, 0, base}, halfX, halfY, {middle - 0.5 * slant, 0, base + height}, halfX - 0.5 * slant,
              halfY, paint);
    const double low = 0.55, high = 0.82, out = 0.03;
    s.tapered({middle - 0.5 * slant * low, 0, base + low * height}, halfX - 0.5 * slant * low + out,
              halfY + out, {middle - 0.5 * slant * high, 0, base + high * height},
              halfX - 0.5 * slant * high + out, halfY + out, windows);
    return base + height;
}

void Builder::mast(double x, double base, double top, Paint paint, bool radar) {
    const double r = std::clamp(0.004 * f.length_m, 0.06, 0.35);
    shape.upperworks.bar({x, 0, base}, {x, 0, top}, r, paint);
    if (!radar) return;
    const double at = base + 0.55 * (top - base), half = std::clamp(0.02 * f.length_m, 0.5, 2.0);
    shape.upperworks.box({x + 0.4, 0, at}, 0.15, half, 0.25, kWhite);
    shape.detail.bar({x, -1.5 * half, base + 0.75 * (top - base)},
                     {x, 1.5 * half, base + 0.75 * (top - base)}, 0.5 * r, paint, 4);
}

void Builder::rail(double x0, double x1, double height) {
    const int posts = std::max(2, static_cast<int>((x1 - x0) / 2.0));
    for (const double side : {-1.0, 1.0}) {
        Point last{};
        for (int i = 0; i <= posts; ++i) {
            const double x = x0 + (x1 - x0) * i / posts;
            const Point foot{x, side * (deckHalfBreadth_m(f, x) - 0.1), deck(x)},
                top = foot + Point{0, 0, height};
            shape.detail.bar(foot, top, 0.03, kWhite, 3);
            if (i > 0) shape.detail.bar(last, top, 0.03, kWhite, 3);
            last = top;
        }
    }
}

void Builder::funnel(double x, double base, double height, double size, Paint paint) {
    shape.upperworks.tapered({x, 0, base}, 1.4 * size, size, {x - 0.3 * size, 0, base + height}, 1.1 * size,
                             0.8 * size, paint);
    shape.upperworks.box({x - 0.3 * size, 0, base + height}, size, 0.7 * size, 0.12 * height, kDarkGrey);
}

void Builder::patrol() {
    hull({{0.30, 0.09, 0.08}, kGrey, {0.33, 0.37, 0.38}});
    const double front = f.bridge_m + L(0.022), d = deck(f.bridge_m);
    // Foredeck: breakwater, gun, windlass, bollards.
    const double gun = f.bridge_m + L(0.15), g = deck(gun);
    shape.hull.turned(
        {gun, 0, g}, std::array<Solid::Ring, 3>{{{0, 1.5, kGrey}, {0.5, 1.5, kGrey}, {0.9, 1.2, kGrey}}}, 10);
    shape.hull.tapered({gun, 0, g + 0.9}, 1.3, 1.0, {gun - 0.1, 0, g + 2.0}, 0.8, 0.7, darker(kGrey, 1.05));
    shape.hull.bar({gun + 0.9, 0, g + 1.5}, {gun + 4.2, 0, g + 1.9}, 0.09, kDarkGrey, 6);
    const double windlass = L(0.5) - L(0.10);
    shape.hull.box({windlass, 0, deck(windlass)}, 0.5, 0.9, 0.8, kDarkGrey);
    for (const double side : {-1.0, 1.0}) {
        for (const double x : {L(0.30), L(0.44)})
            shape.hull.box({x, side * (deckHalfBreadth_m(f, x) - 0.5), deck(x)}, 0.35, 0.15, 0.4, kDarkGrey);
        const double x = gun - 4.0;
        shape.hull.quad({x, side * 0.1, deck(x)}, {x - 1.0, side * (deckHalfBreadth_m(f, x) - 0.4), deck(x)},
                        {x - 1.0, side * (deckHalfBreadth_m(f, x) - 0.4), deck(x) + 0.5},
                        {x, side * 0.1, deck(x) + 0.6}, kGrey);
    }
    shape.hull.bar({L(0.485), 0, deck(L(0.485))}, {L(0.485), 0, deck(L(0.485)) + 2.2}, 0.05, kWhite, 4);
    // Superstructure.
    Solid& up = shape.upperworks;
    const double floor = f.bridgeHeight_m - 1.7;
    house(up, -L(0.14), front - 0.5, B(0.40), d - 0.3, floor - d + 0.3, kGrey, kPortholes, 0.8);
    const double top = house(up, f.bridge_m - L(0.09), front, B(0.36), floor, 2.9, kGrey, kGlass, 0.9);
    house(up, -L(0.30), -L(0.14), B(0.30), deck(-L(0.2)), 2.6, kGrey, kPortholes);
    funnel(-L(0.10), floor, 3.0, B(0.15), kGrey);
    up.tapered({f.bridge_m - L(0.05), 0, top}, 1.3, 1.3, {f.bridge_m - L(0.07), 0, top + 7.5}, 0.25, 0.25,
               kGrey);
    mast(f.bridge_m - L(0.07), top + 3.0, top + 9.5, kGrey, true);
    up.box({-L(0.36), 0, deck(-L(0.36))}, 2.6, 1.0, 1.0, kOrange);  // boat
    up.bar({-L(0.33), -1.5, deck(-L(0.33))}, {-L(0.37), 0.5, deck(-L(0.33)) + 3.6}, 0.12, kGrey, 5);
    rail(-L(0.49), L(0.47), 1.0);
}

void Builder::fishing() {
    constexpr Paint kHulls[] = {
        {0.12, 0.36, 0.62}, {0.16, 0.50, 0.42}, {0.70, 0.24, 0.14}, {0.80, 0.72, 0.28}, {0.84, 0.86, 0.86}};
    constexpr Paint kHouses[] = {{0.85, 0.85, 0.82}, {0.88, 0.66, 0.20}, {0.30, 0.62, 0.75}};
    const Paint house_ = kHouses[m_variant % 3];
    hull({{0.45, 0.12, 0.10}, kHulls[m_variant % 5], {0.46, 0.36, 0.26}});
    const double x0 = -L(0.28), x1 = -L(0.02), base = deck(x0);
    const double top = house(shape.upperworks, x0, x1, B(0.30), base, 2.1, house_, kGlass, 0.15);
    shape.upperworks.box({0.5 * (x0 + x1), 0, top}, 0.5 * (x1 - x0) + 0.3, B(0.34), 0.10,
                         darker(house_, 0.7));
    mast(x1 + 0.3, base, top + L(0.28), kSteel, false);
    shape.upperworks.bar({x1 + 0.3, 0, base + 1.2}, {-L(0.46), 0, top + 0.8}, 0.06, kSteel, 4);
    shape.hull.box({L(0.14), 0, deck(L(0.14)) - 0.05}, L(0.07), B(0.22), 0.55, darker(house_, 0.8));
    shape.hull.box({L(0.30), B(0.1), deck(L(0.30))}, 0.5, 0.4, 0.5, kOrange);
    for (const double side : {-1.0, 1.0})
        shape.detail.bar({-L(0.10), side * B(0.35), base}, {-L(0.14), side * B(1.0), top + L(0.22)}, 0.05,
                         kBuff, 3);
}

void Builder::cargo(bool tanker, bool containers) {
    constexpr Paint kHulls[] = {
        {0.10, 0.16, 0.30}, {0.14, 0.14, 0.15}, {0.42, 0.12, 0.10}, {0.10, 0.30, 0.22}};
    hull({{0.48, 0.13, 0.10},
          kHulls[m_variant % 4],
          tanker ? Paint{0.45, 0.20, 0.16} : Paint{0.28, 0.36, 0.32}});
    Solid& up = shape.upperworks;
    const double aft = -L(0.44), front = f.bridge_m, d = deck(0.5 * (aft + front));
    const double storeys = std::max(2.0, std::round((f.bridgeHeight_m - 1.0 - d) / 2.8));
    const double each = (f.bridgeHeight_m + 1.0 - d) / (storeys + 1.0);
    double top = d;
    for (int i = 0; i < static_cast<int>(storeys); ++i)
        top = house(up, aft + L(0.012) * i, front - L(0.004) * i, B(0.46), top, each, kWhite, kPortholes);
    top = house(up, front - L(0.06), front, B(0.40), top, each, kWhite, kGlass);
    up.box({front - L(0.03), 0, top - each}, L(0.012), B(0.52), 0.25 * each, kWhite);  // wings
    funnel(aft + L(0.04), top - 2.0 * each, 2.4 * each, B(0.10),
           m_variant % 2 == 0 ? kBuff : Paint{0.15, 0.30, 0.55});
    mast(front - L(0.04), top, top + L(0.07) + 2.0, kWhite, true);
    mast(L(0.42), deck(L(0.42)), deck(L(0.42)) + L(0.08) + 2.0, kBuff, false);
    Solid& s = shape.hull;
    s.box({L(0.43), 0, deck(L(0.43))}, L(0.03), B(0.18), 1.2, kSteel);
    const double from = front + L(0.03), to = L(0.36);
    if (containers) {
        constexpr Paint kBoxes[] = {{0.62, 0.20, 0.14},
                                    {0.15, 0.32, 0.52},
                                    {0.70, 0.68, 0.62},
                                    {0.20, 0.42, 0.30},
                                    {0.78, 0.48, 0.14}};
        const int bays = std::max(2, static_cast<int>((to - from) / 13.5));
        unsigned pick = m_variant * 7u + 3u;
        for (int bay = 0; bay < bays; ++bay) {
            const double x = from + (bay + 0.5) * (to - from) / bays;
            for (int row = 0; row < 4; ++row) {
                pick = pick * 1664525u + 1013904223u;
                const double high = 2.6 * (2 + (pick >> 28) % 4);
                s.box({x, B(0.23) * (row - 1.5), deck(x) + 1.0}, 0.46 * (to - from) / bays, B(0.112), high,
                      kBoxes[(pick >> 20) % 5]);
            }
        }
    } else if (tanker) {
        s.bar({from, 0, d + 1.2}, {to, 0, d + 1.2}, 0.02 * f.beam_m, {0.62, 0.34, 0.26});
        s.box({0.5 * (from + to), 0, d}, 1.2, B(0.40), 2.0, {0.55, 0.30, 0.24});
        shape.detail.bar({0.5 * (from + to), B(0.2), d}, {0.5 * (from + to), B(0.2), d + L(0.06)}, 0.4,
                         kWhite);
        shape.detail.bar({from, B(0.12), d + 0.9}, {to, B(0.12), d + 0.9}, 0.012 * f.beam_m,
                         {0.62, 0.34, 0.26});
        shape.detail.bar({from, -B(0.12), d + 0.9}, {to, -B(0.12), d + 0.9}, 0.012 * f.beam_m,
                         {0.62, 0.34, 0.26});
    } else {
        const int hatches = 2;
        for (int i = 0; i < hatches; ++i) {
            const double x = from + (i + 0.5) * (to - from) / hatches;
            s.box({x, 0, deck(x)}, 0.42 * (to - from) / hatches, B(0.34), 1.5, {0.40, 0.26, 0.18});
        }
        const double crane = 0.5 * (from + to), c = deck(crane);
        up.bar({crane, 0, c}, {crane, 0, c + L(0.11)}, 0.03 * f.beam_m, kBuff, 6);
        up.bar({crane, 0, c + L(0.10)}, {crane + 0.4 * (to - from), 0, c + L(0.07)}, 0.015 * f.beam_m, kBuff,
               4);
    }
    rail(L(0.36), L(0.48), 1.0);
}

void Builder::ferry() {
    hull({{0.40, 0.12, 0.10}, kWhite, {0.30, 0.36, 0.34}});
    Solid& up = shape.upperworks;
    double top = deck(0.0) - 0.3;
    top = house(up, -L(0.46), L(0.34), B(0.49), top, 3.2, kWhite, kPortholes, 1.0);
    top = house(up, -L(0.42), L(0.32), B(0.47), top, 2.8, kWhite, kPortholes, 1.5);
    top = house(up, f.bridge_m - L(0.08), f.bridge_m + 1.0, B(0.45), top, 2.9, kWhite, kGlass, 1.0);
    funnel(-L(0.25), top - 2.9, 6.0, B(0.12), {0.12, 0.28, 0.55});
    mast(f.bridge_m - L(0.05), top, top + 7.0, kWhite, true);
}

void Builder::yacht() {
    hull({{0.15, 0.20, 0.35}, kWhite, {0.58, 0.46, 0.32}});
    const double d = deck(0.0);
    house(shape.upperworks, -L(0.12), L(0.16), B(0.26), d - 0.1, 0.75, kWhite, kGlass, 0.5);
    shape.upperworks.bar({L(0.08), 0, d}, {L(0.08), 0, d + 1.25 * f.length_m}, 0.10, {0.75, 0.75, 0.76}, 6);
    const Point head{L(0.075), 0, d + 1.2 * f.length_m}, tack{L(0.07), 0, d + 1.4},
        clew{-L(0.32), 0.8, d + 1.4};
    shape.upperworks.triangle(tack, clew, head, {0.93, 0.92, 0.88});
    shape.upperworks.triangle({L(0.47), 0, deck(L(0.47)) + 0.3}, {L(0.0), -1.0, d + 1.0},
                              {L(0.1), 0, d + 1.05 * f.length_m}, {0.91, 0.90, 0.86});
}

void Builder::tug() {
    hull({{0.42, 0.12, 0.10}, {0.12, 0.14, 0.18}, {0.34, 0.22, 0.18}});
    const double d = deck(0.1 * f.length_m);
    double top = house(shape.upperworks, -L(0.12), L(0.24), B(0.34), d, 2.6, kWhite, kPortholes);
    top = house(shape.upperworks, L(0.0), L(0.16), B(0.26), top, 2.6, kWhite, kGlass, 0.4);
    funnel(-L(0.10), d + 2.0, 3.5, B(0.09), kOrange);
    mast(L(0.05), top, top + 6.0, kBuff, true);
    shape.hull.box({-L(0.22), 0, deck(-L(0.22))}, 0.8, 0.9, 1.2, kDarkGrey);
}

void Builder::fastCraft() {
    hull({{0.15, 0.15, 0.16},
          m_variant % 2 == 0 ? Paint{0.24, 0.30, 0.34} : Paint{0.50, 0.52, 0.50},
          {0.40, 0.40, 0.38}});
    const double d = deck(0.0);
    shape.upperworks.box({-L(0.06), 0, d - 0.1}, 0.5, 0.5, 1.1, kWhite);
    shape.upperworks.quad({-L(0.0), -0.5, d + 0.9}, {-L(0.0), 0.5, d + 0.9}, {-L(0.04), 0.45, d + 1.5},
                          {-L(0.04), -0.45, d + 1.5}, kGlass);
    for (const double side : {-0.35, 0.35})
        shape.upperworks.box({-L(0.49), side, 0.0}, 0.3, 0.22, 1.2, kDarkGrey);
    for (const double x : {-L(0.14), -L(0.22)})  // crew
        for (const double side : {-0.4, 0.45})
            shape.upperworks.box({x, side, d - 0.2}, 0.2, 0.24, 1.5, {0.20, 0.18, 0.16});
}

ShipShape Builder::build() {
    switch (f.style) {
        case ShipStyle::Patrol:
            patrol();
            break;
        case ShipStyle::Fishing:
            fishing();
            break;
        case ShipStyle::Coaster:
            cargo(false, false);
            break;
        case ShipStyle::Tanker:
            cargo(true, false);
            break;
        case ShipStyle::Container:
            cargo(false, true);
            break;
        case ShipStyle::Ferry:
            ferry();
            break;
        case ShipStyle::Yacht:
            yacht();
            break;
        case ShipStyle::Tug:
            tug();
            break;
        case ShipStyle::FastCraft:
            fastCraft();
            break;
    }
    if (f.length_m < kLow_m) shape.lid = hullLid(f);
    // Staffs for the lights on her centreline that no mast carries.
    for (const ShipLight& light : lightsOf(f, core::Activity::UnderWay)) {
        const Point p = light.position;
        if (p.y == 0.0) shape.upperworks.bar({p.x, 0, deck(p.x)}, {p.x, 0, p.up + 0.25}, 0.06, kSteel, 4);
    }
    return std::move(shape);
}

}  // namespace

ShipShape shapeOf(const ShipForm& form, unsigned variant) { return Builder(form, variant).build(); }

}  // namespace sagara::render
