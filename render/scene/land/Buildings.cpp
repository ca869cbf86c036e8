#include "render/scene/land/Buildings.h"

#include <array>
#include <cmath>
#include <map>

#include "core/base/Random.h"
#include "core/base/Units.h"

namespace sagara::render {
namespace {

constexpr Paint kWhite{0.90, 0.89, 0.86};
constexpr Paint kLantern{0.62, 0.68, 0.66};  // glass; the light in it is LightsPart's
constexpr Paint kRoofs[] = {{0.52, 0.23, 0.15}, {0.45, 0.26, 0.19}, {0.40, 0.36, 0.33}};
constexpr Paint kWalls[] = {{0.84, 0.80, 0.70}, {0.88, 0.86, 0.82}, {0.80, 0.72, 0.54}, {0.72, 0.76, 0.74}};
constexpr Paint kWindow{0.14, 0.14, 0.15, 0.8};
constexpr double kPiece_m = 1120.0;

/// A house with a gable roof; a window in each long side.
Solid house(double halfX, double halfY, double wall_m, Paint walls, Paint roof, bool windows) {
    Solid s;
    const double top = wall_m + 0.7 * halfY;
    const Point a{halfX, halfY, wall_m}, b{halfX, -halfY, wall_m}, c{-halfX, -halfY, wall_m},
        d{-halfX, halfY, wall_m};
    const auto ground = [](Point p) { return Point{p.x, p.y, -2.0}; };
    s.quad(ground(a), ground(b), b, a, walls);
    s.quad(ground(b), ground(c), c, b, walls);
    s.quad(ground(c), ground(d), d, c, walls);
    s.quad(ground(d), ground(a), a, d, walls);
    const Point front{halfX + 0.3, 0, top}, back{-halfX - 0.3, 0, top};
    const auto eave = [](Point p) { return Point{1.06 * p.x, 1.1 * p.y, p.up - 0.15}; };
    s.quad(eave(d), eave(a), front, back, roof);
    s.quad(eave(c), eave(b), front, back, roof);
    s.triangle(a, b, {halfX, 0, top}, walls);
    s.triangle(c, d, {-halfX, 0, top}, walls);
    if (windows) {
        for (const double side : {-1.0, 1.0}) {
            const double y = side * (halfY + 0.05), w = 0.3 * halfX;
            s.quad({-w, y, 0.35 * wall_m}, {w, y, 0.35 * wall_m}, {w, y, 0.75 * wall_m},
                   {-w, y, 0.75 * wall_m}, kWindow);
        }
    }
    return s;
}

Solid palm(core::Random& random) {
    Solid s;
    const double height = 8.0 + 6.0 * random.uniform(), lean = 2.5 * (random.uniform() - 0.5);
    const Point crown{lean, 0.3 * lean, height};
    s.bar({0, 0, -1.0}, crown, 0.17, {0.36, 0.30, 0.22}, 3);
    for (int i = 0; i < 7; ++i) {
        const double a = core::kTwoPi * (i + 0.4 * random.uniform()) / 7.0, r = 2.7 + 0.9 * random.uniform();
        const Point out{std::cos(a), std::sin(a), 0.0}, side{-0.45 * std::sin(a), 0.45 * std::cos(a), 0.0};
        const Point middle = crown + (0.55 * r) * out + Point{0, 0, 0.45},
                    tip = crown + r * out + Point{0, 0, -1.0};
        const Paint green = mixed({0.14, 0.27, 0.08}, {0.26, 0.38, 0.14}, random.uniform());
        s.quad(crown, middle + side, tip, middle - side, green);
    }
    return s;
}

class Builder {
public:
    Builder(const core::Area& area, const Ground& ground, const PresetFigures& figures)
        : m_area(area), m_ground(ground), m_figures(figures) {}
    std::vector<Solid> build();

private:
    Solid& pieceAt(core::NorthEast p) {
        return m_pieces[{static_cast<int>(std::floor(p.north_m / kPiece_m)),
                         static_cast<int>(std::floor(p.east_m / kPiece_m))}];
    }
    double groundAt(core::NorthEast p) const { return m_ground.height_m(p, m_ground.spot(p), false); }
    void put(const Solid& solid, core::NorthEast p, double turn_rad = 0.0) {
        pieceAt(p).append(solid, {p.north_m, p.east_m, groundAt(p)}, turn_rad);
    }
    void lighthouse(const core::Mark& mark);
    void landmarks();
    void sheds();
    void houses();
    void palms();

    const core::Area& m_area;
    const Ground& m_ground;
    const PresetFigures& m_figures;
    core::Random m_random{6020};
    std::map<std::pair<int, int>, Solid> m_pieces;
};

/// A white tower whose lamp is at the height the light list gives.
void Builder::lighthouse(const core::Mark& mark) {
    const double lamp = mark.light ? mark.light->height_m : 25.0;
    Solid s;
    s.turned({},
             std::array<Solid::Ring, 7>{{{-2.0, 3.3, kWhite},
                                         {lamp - 3.0, 2.0, kWhite},
                                         {lamp - 2.2, 2.9, kWhite},
                                         {lamp - 1.9, 2.9, darker(kWhite, 0.6)},
                                         {lamp - 1.8, 1.5, kLantern},
                                         {lamp + 1.2, 1.5, {0.55, 0.12, 0.10}},
                                         {lamp + 3.0, 0.15, {0.55, 0.12, 0.10}}}},
             14);
    pieceAt(mark.position).append(s, {mark.position.north_m, mark.position.east_m, 0.0});
}

void Builder::landmarks() {
    for (const core::Place& place : m_area.places) {
        if (place.id == "peace_pagoda") {
            Solid s;
            s.turned({},
                     std::array<Solid::Ring, 7>{{{-4.0, 17.0, kWhite},
                                                 {4.0, 17.0, kWhite},
                                                 {4.1, 12.0, kWhite},
                                                 {10.0, 11.0, kWhite},
                                                 {15.0, 7.5, kWhite},
                                                 {18.0, 1.8, {0.80, 0.66, 0.28}},
                                                 {26.0, 0.2, {0.80, 0.66, 0.28}}}},
                     16);
            pieceAt(place.position)
                .append(s, {place.position.north_m, place.position.east_m,
                            m_ground.height_m(place.position, m_ground.spot(place.position), true) - 2.0});
        } else if (place.id == "clock_tower") {
            Solid s;
            s.tapered({0, 0, -2}, 2.6, 2.6, {0, 0, 22}, 2.2, 2.2, {0.80, 0.76, 0.66});
            s.tapered({0, 0, 22}, 2.6, 2.6, {0, 0, 27}, 0.2, 0.2, {0.45, 0.40, 0.36});
            put(s, place.position);
        } else if (place.id == "dutch_church") {
            put(house(14.0, 7.0, 9.0, kWhite, kRoofs[1], true), place.position, 0.2);
        } else if (place.id == "stadium") {
            put(house(35.0, 6.0, 6.0, {0.70, 0.72, 0.72}, {0.35, 0.42, 0.50}, false), place.position, 1.2);
        }
    }
}

/// Along each quay, where there is ground behind it.
void Builder::sheds() {
    for (const core::Berth& berth : m_area.berths) {
        const core::NorthEast along = berth.along(), inward = -1.0 * berth.outward();
        const double length_m = core::distance(berth.face.a, berth.face.b);
        const double turn = std::atan2(along.east_m, along.north_m);
        for (double at = 45.0; at + 35.0 < length_m; at += 85.0) {
            const core::NorthEast p = berth.face.a + at * along + 32.0 * inward;
            if (m_ground.spot(p).inland_m < 12.0 || m_ground.spot(p + 14.0 * inward).inland_m < 4.0) continue;
            put(house(30.0, 9.0, 6.5, {0.62, 0.65, 0.66}, {0.42, 0.46, 0.48}, false), p, turn);
        }
        for (double at = 10.0; at < length_m; at += 24.0) {  // fenders on the face
            const core::NorthEast p = berth.face.a + at * along;
            pieceAt(p).box({p.north_m, p.east_m, -0.6}, 0.6, 0.35, 2.2, {0.10, 0.10, 0.11}, turn);
        }
        for (const core::Berth::Bollard& bollard : berth.bollards)
            pieceAt(bollard.position)
                .box({bollard.position.north_m, bollard.position.east_m, 1.9}, 0.22, 0.22, 0.5,
                     {0.16, 0.16, 0.16});
    }
}

void Builder::houses() {
    // About places where people live; the fort is full, elsewhere they thin out.
    struct Quarter {
        const char* place;
        double radius_m;
        double share;
        double turn_rad;
    };
    constexpr Quarter kQuarters[] = {{"fort", 330.0, 0.40, 0.25},         {"stadium", 420.0, 0.16, 0.1},
                                     {"railway_station", 700.0, 0.16, 0}, {"dewata_beach", 600.0, 0.10, 0.4},
                                     {"port_wpi", 900.0, 0.12, 0},        {"unawatuna_bay", 700.0, 0.06, 0}};
    for (const Quarter& quarter : kQuarters) {
        const core::Place* place = m_area.findPlace(quarter.place);
        if (place == nullptr) continue;
        const int wanted = static_cast<int>(quarter.share * m_figures.houses);
        int built = 0;
        for (int tries = 0; tries < 8 * wanted && built < wanted; ++tries) {
            const double r = quarter.radius_m * std::sqrt(m_random.uniform()),
                         a = core::kTwoPi * m_random.uniform();
            const core::NorthEast p = place->position + core::NorthEast{r * std::cos(a), r * std::sin(a)};
            const Ground::Spot spot = m_ground.spot(p);
            const unsigned pick = static_cast<unsigned>(m_random.next() >> 40);
            const double halfX = 5.0 + 5.0 * m_random.uniform(), halfY = 3.5 + 2.0 * m_random.uniform();
            const double storeys = 1.0 + static_cast<double>(pick % 3 == 0);
            if (spot.inland_m < 26.0 || (m_ground.works(spot) && spot.inland_m < 40.0)) continue;
            ++built;
            put(house(halfX, halfY, 3.3 * storeys + 0.8, kWalls[pick % 4], kRoofs[(pick >> 3) % 3], true), p,
                quarter.turn_rad + (pick & 16u ? 0.5 * core::kPi : 0.0));
        }
    }
}

void Builder::palms() {
    int planted = 0;
    for (int tries = 0; tries < 60 * m_figures.palms && planted < m_figures.palms; ++tries) {
        const core::NorthEast p{-2500.0 + 4800.0 * m_random.uniform(), -2200.0 + 4600.0 * m_random.uniform()};
        const Ground::Spot spot = m_ground.spot(p);
        if (spot.inland_m < 14.0 || spot.inland_m > 55.0 || m_ground.works(spot) || spot.fort) continue;
        ++planted;
        put(palm(m_random), p, core::kTwoPi * m_random.uniform());
    }
}

std::vector<Solid> Builder::build() {
    for (const core::Mark& mark : m_area.marks)
        if (mark.kind == core::MarkKind::Lighthouse) lighthouse(mark);
    landmarks();
    sheds();
    houses();
    palms();
    std::vector<Solid> solids;
    for (auto& [key, solid] : m_pieces) solids.push_back(std::move(solid));
    return solids;
}

}  // namespace

std::vector<Solid> buildings(const core::Area& area, const Ground& ground, const PresetFigures& figures) {
    return Builder(area, ground, figures).build();
}

}  // namespace sagara::render
