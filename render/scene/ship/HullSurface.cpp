#include "render/scene/ship/HullSurface.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

double deckHalfBreadth_m(const ShipForm& f, double x_m) {
    return 0.5 * f.beam_m * lineAt(f, std::clamp(2.0 * x_m / f.length_m, -1.0, 1.0), true);
}

Solid hullSurface(const ShipForm& f, const HullPaint& paint) {
    Solid hull;
    std::vector<std::vector<Point>> starboard, port, deck;
    std::vector<std::vector<Paint>> paints, deckPaints;
    const double band = std::max(0.1, 0.03 * f.draught_m + 0.05);  // sharp edge of the bottom paint
    for (int i = 0; i <= kStations; ++i) {
        // Closer at the ends.
        const double s = std::sin(0.5 * 3.14159265 * (2.0 * i / kStations - 1.0));
        const double deckUp = f.deckAt_m(0.5 * f.length_m * s);
        const double heights[] = {
            -f.draught_m, -0.9 * f.draught_m,      -0.5 * f.draught_m, band, band + 0.02, 0.55 * deckUp,
            deckUp,       deckUp + bulwarkAt(f, s)};
        std::vector<Point> right, left;
        for (const double up : heights) {
            Point p = shellAt(f, s, std::min(up, deckUp));
            p.up = up;
            right.push_back(p);
            left.push_back({p.x, -p.y, p.up});
        }
        paints.push_back({paint.bottom, paint.bottom, paint.bottom, paint.bottom, paint.side, paint.side,
                          paint.side, paint.side});
        const Point edge = right[6];
        deck.push_back({{edge.x, edge.y, edge.up},
                        {edge.x, 0.0, edge.up + 0.02 * f.beam_m},
                        {edge.x, -edge.y, edge.up}});
        deckPaints.push_back({paint.deck, paint.deck, paint.deck});
        starboard.push_back(std::move(right));
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
