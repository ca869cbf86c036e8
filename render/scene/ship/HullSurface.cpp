#include "render/scene/ship/HullSurface.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sagara::render {
namespace {

constexpr int kStations = 20;

/// A waterline or deck line: share of the half beam at s, -1 stern to 1 bow.
double lineAt(const ShipForm& f, double s, bool deck) {
    const double middle = std::clamp(1.6 * (f.block - 0.45), 0.05, 0.6);
    const double bowFrom = 0.9 * middle - 0.05, sternFrom = -0.8 * middle;
    if (s > bowFrom) {
        const double t = (s - bowFrom) / (1.0 - bowFrom);
        return 1.0 - std::pow(t, (deck ? 2.7 : 1.7) + 1.5 * std::max(0.0, f.block - 0.5));
    }
    if (s < sternFrom) {
        const double t = (sternFrom - s) / (1.0 + sternFrom);
        const double transom = deck ? 0.85 : f.block > 0.65 ? 0.25 : 0.7;
        return 1.0 - (1.0 - transom) * t * t;
    }
    return 1.0;
}

/// A point of the starboard shell: share of the length, height above the waterline.
Point shellAt(const ShipForm& f, double s, double up) {
    const double deckUp = f.deckAt_m(0.5 * f.length_m * s), half = 0.5 * f.beam_m;
    double y = 0.0;
    if (up >= 0.0) {
        const double g = std::min(1.0, up / deckUp);
        y = half * (lineAt(f, s, false) * (1.0 - g) + lineAt(f, s, true) * g);
    } else {
        const double u = std::min(1.0, -up / f.draught_m);
        const double bow = std::clamp((s - 0.3) / 0.7, 0.0, 1.0);
        const double n = (2.0 + 6.0 * std::max(0.0, f.block - 0.5)) * (1.0 - bow) + 1.3 * bow;
        y = half * lineAt(f, s, false) * std::pow(std::max(0.0, 1.0 - std::pow(u, n)), 1.0 / n);
    }
    const double low = 1.0 - std::clamp((up + f.draught_m) / (deckUp + f.draught_m), 0.0, 1.0);
    const double rake = 0.10 * std::max(0.0, (s - 0.6) / 0.4),
                 counter = 0.05 * std::max(0.0, (-s - 0.7) / 0.3);
    return {f.length_m * (0.5 * s + low * (counter - rake)), y, up};
}

double bulwarkAt(const ShipForm& f, double s) {
    const double height = std::clamp(0.02 * f.length_m, 0.25, 1.1);
    return s > 0.35 || f.style == ShipStyle::Fishing || f.style == ShipStyle::Tug ? height : 0.02;
}

/// Upper edge of the bottom paint above the waterline; it is sharp.
double bandOf(const ShipForm& f) { return std::max(0.1, 0.03 * f.draught_m + 0.05); }
constexpr double kSharp_m = 0.02;

/// Rows of the starboard shell from aft forward, each from the keel up to the bulwark's top; the last but one
/// point is the edge of the deck.
struct Shell {
    std::vector<std::vector<Point>> rows;
    std::size_t bottomPoints;  ///< points of a row in bottom paint
};

Shell shellOfForm(const ShipForm& f) {
    Shell shell{{}, 4};
    const double band = bandOf(f);
    for (int i = 0; i <= kStations; ++i) {
        // Closer at the ends.
        const double s = std::sin(0.5 * 3.14159265 * (2.0 * i / kStations - 1.0));
        const double deckUp = f.deckAt_m(0.5 * f.length_m * s);
        const double heights[] = {-f.draught_m, -0.9 * f.draught_m,      -0.5 * f.draught_m,
                                  band,         band + kSharp_m,         0.55 * deckUp,
                                  deckUp,       deckUp + bulwarkAt(f, s)};
        std::vector<Point> row;
        for (const double up : heights) {
            Point p = shellAt(f, s, std::min(up, deckUp));
            p.up = up;
            row.push_back(p);
        }
        shell.rows.push_back(std::move(row));
    }
    return shell;
}

double waterHalfBreadth_m(const std::vector<core::HullStation>& stations, double x_m) {
    const auto after = std::find_if(stations.begin(), stations.end(),
                                    [&](const core::HullStation& s) { return s.x_m >= x_m; });
    if (after == stations.end() || (after == stations.begin() && after->x_m > x_m)) return 0.0;
    if (after == stations.begin()) return 0.5 * after->breadth_m;
    const core::HullStation &a = after[-1], &b = after[0];
    const double g = (x_m - a.x_m) / (b.x_m - a.x_m);
    return 0.5 * (a.breadth_m + g * (b.breadth_m - a.breadth_m));
}

/// Exponent n of the section y = b (1 - u^n)^(1/n), u from 0 at the waterline to 1 at the keel, that fills
/// this share of its box: 0.5 is a wedge, 0.785 an ellipse. A bulb, fuller than its box, is drawn as a box.
double exponentFor(double fullness) {
    const auto filled = [](double n) {
        return std::pow(std::tgamma(1.0 + 1.0 / n), 2) / std::tgamma(1.0 + 2.0 / n);
    };
    double low = 0.25, high = 40.0;
    for (int i = 0; i < 40; ++i) {
        const double n = 0.5 * (low + high);
        (filled(n) < fullness ? low : high) = n;
    }
    return low;
}

/// Depths of a row's points as shares of the local draught; then heights above the water as in shellOfForm.
constexpr double kDepths[] = {1.0, 0.95, 0.75, 0.45, 0.2, 0.0};

std::vector<double> heightsAbove(const ShipForm& f, double x_m) {
    const double deckUp = f.deckAt_m(x_m), band = bandOf(f);
    return {band, band + kSharp_m, 0.55 * deckUp, deckUp, deckUp + bulwarkAt(f, 2.0 * x_m / f.length_m)};
}

/// A row through one station; above the water it flares to the edge of the deck.
std::vector<Point> rowThrough(const ShipForm& f, const core::HullStation& s) {
    const double half = 0.5 * s.breadth_m, deckUp = f.deckAt_m(s.x_m), deckHalf = deckHalfBreadth_m(f, s.x_m);
    const double box = s.breadth_m * s.draught_m;
    const double n = exponentFor(box > 0.0 ? s.area_m2 / box : 1.0);
    std::vector<Point> row;
    for (const double u : kDepths)
        row.push_back({s.x_m, half * std::pow(1.0 - std::pow(u, n), 1.0 / n), -u * s.draught_m});
    for (const double up : heightsAbove(f, s.x_m)) {
        const double g = std::min(1.0, up / deckUp);
        row.push_back({s.x_m, half + (deckHalf - half) * g * g, up});
    }
    return row;
}

/// The stem, ahead of the first section: raked from the last station to the bow.
std::vector<Point> stemOf(const ShipForm& f, const core::HullStation& last) {
    const double bow = std::max(f.bow_m(), last.x_m + 0.25 * last.breadth_m);
    const double water = last.x_m + std::min(0.5 * last.breadth_m, 0.4 * (bow - last.x_m));
    std::vector<Point> row;
    for (const double u : kDepths)
        row.push_back({last.x_m + (water - last.x_m) * (1.0 - u), 0.0, -u * last.draught_m});
    for (const double up : heightsAbove(f, bow))
        row.push_back({water + (bow - water) * std::min(1.0, up / f.deckAt_m(bow)), 0.0, up});
    return row;
}

/// A transom that stands out over the water behind the aftermost station.
std::vector<Point> transomOf(const ShipForm& f) {
    const double x = -f.bow_m(), half = deckHalfBreadth_m(f, x),
                 foot = std::max(bandOf(f), 0.3 * f.deckAt_m(x));
    std::vector<Point> row;
    for (const double u : kDepths) row.push_back({x, 0.85 * half * (1.0 - u), foot});
    for (const double up : heightsAbove(f, x)) {
        const double g = std::clamp((up - foot) / (f.deckAt_m(x) - foot), 0.0, 1.0);
        row.push_back({x, half * (0.85 + 0.15 * g), std::max(foot, up)});
    }
    return row;
}

Shell shellOfStations(const ShipForm& f) {
    Shell shell{{}, std::size(kDepths) + 1};
    if (f.stations.front().x_m > -0.495 * f.length_m) shell.rows.push_back(transomOf(f));
    for (const core::HullStation& s : f.stations) shell.rows.push_back(rowThrough(f, s));
    shell.rows.push_back(stemOf(f, f.stations.back()));
    return shell;
}

Shell shellOf(const ShipForm& f) { return f.stations.empty() ? shellOfForm(f) : shellOfStations(f); }

}  // namespace

double deckHalfBreadth_m(const ShipForm& f, double x_m) {
    const double line = 0.5 * f.beam_m * lineAt(f, std::clamp(2.0 * x_m / f.length_m, -1.0, 1.0), true);
    return std::max(line, waterHalfBreadth_m(f.stations, x_m));
}

Solid hullLid(const ShipForm& f) {
    Solid lid;
    std::vector<std::vector<Point>> rows;
    std::vector<std::vector<Paint>> paints;
    for (const std::vector<Point>& row : shellOf(f).rows) {
        rows.push_back({row.back(), {row.back().x, -row.back().y, row.back().up}});
        paints.push_back({{}, {}});
    }
    lid.surface(rows, paints);
    return lid;
}

Solid hullSurface(const ShipForm& f, const HullPaint& paint) {
    Solid hull;
    const Shell shell = shellOf(f);
    const std::vector<std::vector<Point>>& starboard = shell.rows;
    std::vector<std::vector<Point>> port, deck;
    std::vector<std::vector<Paint>> paints, deckPaints;
    for (const std::vector<Point>& right : starboard) {
        std::vector<Point> left;
        for (const Point& p : right) left.push_back({p.x, -p.y, p.up});
        std::vector<Paint> colours(right.size(), paint.side);
        std::fill_n(colours.begin(), shell.bottomPoints, paint.bottom);
        const Point edge = right[right.size() - 2];
        deck.push_back({{edge.x, edge.y, edge.up},
                        {edge.x, 0.0, edge.up + 0.02 * f.beam_m},
                        {edge.x, -edge.y, edge.up}});
        deckPaints.push_back({paint.deck, paint.deck, paint.deck});
        paints.push_back(std::move(colours));
        port.push_back(std::move(left));
    }
    hull.surface(starboard, paints);
    hull.surface(port, paints);
    hull.surface(deck, deckPaints);
    for (std::size_t i = 0; i + 1 < starboard[0].size(); ++i)
        hull.quad(starboard[0][i], starboard[0][i + 1], port[0][i + 1], port[0][i], paints[0][i + 1]);
    return hull;
}

}  // namespace sagara::render
