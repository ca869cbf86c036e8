#include <algorithm>
#include <cmath>

#include "app/tools/CaseRows.h"
#include "app/tools/HullChoice.h"
#include "app/tools/ReferenceTable.h"
#include "core/base/Units.h"
#include "core/seakeeping/Response.h"

namespace sagara::tools {
namespace {

using core::config::Reader;

constexpr int kPointsOfLine = 60;

/// Rows of the table whose number in a column lies here.
struct Span {
    std::string column;
    double from = 0.0, to = 0.0;

    bool holds(const ReferenceTable& table, std::size_t row) const {
        const double value = table.at(column, row);
        return value >= from && value <= to;
    }
};

struct Motion {
    std::size_t index = 0;
    std::string name;
    std::string column;             ///< of the published values
    double above = 0.3;             ///< smaller ones are drawn alone
    std::optional<double> rms;      ///< tolerances of the relative error; none: only drawn
    std::optional<double> largest;  ///< at any one point
    std::vector<Span> claimed;      ///< in all of these; none: everywhere
};

struct RaoCase {
    std::string hull, file;
    bool byLength = true;      ///< the table's column lam_L; else w
    bool withoutEnds = false;  ///< the reference has not the outermost stations
    double heading_deg = 180.0;
    std::optional<double> froude, speed_mps;
    std::optional<double> waveHeight_m;
    std::vector<Span> rows;
    std::vector<Motion> motions;
};

Span readSpan(Reader in) {
    Span span;
    span.column = in.text("column");
    if (in.has("is")) {
        const double is = in.number("is", {-1e6, 1e6, ""});
        span.from = is - 1e-9, span.to = is + 1e-9;
    } else {
        span.from = in.numberOr("from", -1e6, {-1e6, 1e6, ""});
        span.to = in.numberOr("to", 1e6, {-1e6, 1e6, ""});
    }
    in.rejectUnknownKeys();
    return span;
}

Motion readMotion(Reader in) {
    Motion m;
    m.index = in.choice<std::size_t>(
        "motion", {{"surge", 0}, {"sway", 1}, {"heave", 2}, {"roll", 3}, {"pitch", 4}, {"yaw", 5}});
    m.name = in.text("motion");
    m.column = in.text("column");
    m.above = in.numberOr("above", m.above, {0.0, 2.0, ""});
    if (in.has("rms")) m.rms = readShare(in, "rms");
    if (in.has("largest")) m.largest = readShare(in, "largest");
    for (const auto& node : in.listOr("claimed")) m.claimed.push_back(readSpan(Reader(node)));
    in.rejectUnknownKeys();
    return m;
}

RaoCase readCase(Reader& in) {
    RaoCase c;
    c.hull = in.text("hull");
    c.file = in.text("file");
    c.byLength = in.choice<bool>("over", {{"lam_L", true}, {"w", false}});
    c.withoutEnds = in.flagOr("withoutEnds", false);
    c.heading_deg = in.numberOr("heading_deg", c.heading_deg, {0.0, 360.0, "deg"});
    if (in.has("froude")) c.froude = in.number("froude", {0.0, 0.6, ""});
    if (in.has("speed_mps")) c.speed_mps = in.number("speed_mps", {0.0, 60.0, "m/s"});
    if (in.has("waveHeight_m")) c.waveHeight_m = in.number("waveHeight_m", {1e-4, 30.0, "m"});
    for (const auto& node : in.listOr("rows")) c.rows.push_back(readSpan(Reader(node)));
    for (const auto& node : in.list("motions")) c.motions.push_back(readMotion(Reader(node)));
    in.rejectUnknownKeys();
    return c;
}

/// The hull in the waves of the case, asked by what the table goes by.
class HullInWaves {
public:
    HullInWaves(const core::HullForm& form, const RaoCase& c)
        : m_ship(form),
          m_length_m(form.lengthBp_m),
          m_byLength(c.byLength),
          m_heading_rad(c.heading_deg * core::kDegree_rad),
          m_speed_mps(c.froude ? *c.froude * std::sqrt(core::kGravity_mps2 * form.lengthBp_m)
                               : c.speed_mps.value_or(0.0)),
          m_height_m(c.waveHeight_m.value_or(form.lengthBp_m / 50.0)) {}

    /// Over wave amplitude, angles over wave slope.
    std::array<double, 6> at(double x) const {
        const double omega_radps =
            m_byLength ? std::sqrt(core::kTwoPi * core::kGravity_mps2 / (x * m_length_m)) : x;
        const core::MetWave wave{omega_radps, m_heading_rad, m_speed_mps};
        const core::WaveResponse response = m_ship.respond(wave, m_height_m);
        std::array<double, 6> sizes{};
        for (std::size_t i = 0; i < 6; ++i)
            sizes[i] = std::abs(response.atGravity[i]) / (i < 3 ? 1.0 : wave.waveNumber_radpm());
        return sizes;
    }

private:
    core::HullResponse m_ship;
    double m_length_m;
    bool m_byLength;
    double m_heading_rad, m_speed_mps, m_height_m;
};

core::HullForm withoutEnds(core::HullForm form) {
    const auto trim = [](auto& list) {
        if (list.size() > 2) list.erase(list.begin()), list.pop_back();
    };
    trim(form.stations);
    trim(form.offsets);
    return form;
}

struct Point {
    std::size_t row;
    double x;
};

std::vector<Point> pointsOf(const RaoCase& c, const ReferenceTable& table) {
    std::vector<Point> points;
    for (std::size_t row = 0; row < table.rows(); ++row)
        if (std::all_of(c.rows.begin(), c.rows.end(), [&](const Span& s) { return s.holds(table, row); }))
            points.push_back({row, table.at(c.byLength ? "lam_L" : "w", row)});
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
    return points;
}

void addRows(ValidationOutcome& outcome, const Motion& m, const ReferenceTable& table,
             const std::vector<Point>& points, const HullInWaves& ship) {
    if (!m.rms && !m.largest) return;
    RelativeErrors errors;
    for (const Point& p : points) {
        const double published = table.at(m.column, p.row);
        const bool claimed = std::all_of(m.claimed.begin(), m.claimed.end(),
                                         [&](const Span& s) { return s.holds(table, p.row); });
        if (claimed && published > m.above) errors.add(ship.at(p.x)[m.index], published);
    }
    if (m.rms) outcome.rows.push_back(rmsErrorRow(m.name, errors, *m.rms));
    if (m.largest) outcome.rows.push_back(largestErrorRow(m.name, errors, *m.largest));
}

/// Of some of the motions.
report::XyPlot plotOf(const RaoCase& c, const std::vector<Motion>& motions, const ReferenceTable& table,
                      const std::vector<Point>& points, const HullInWaves& ship) {
    report::XyPlot plot;
    plot.xTitle = c.byLength ? "wavelength / ship length" : "wave frequency, rad/s";
    plot.yTitle = "over wave amplitude; angles over wave slope";
    for (const Motion& m : motions) plot.series.push_back({m.name, false, {}});
    for (int i = 0; i <= kPointsOfLine; ++i) {
        const double x = points.front().x + (points.back().x - points.front().x) * i / kPointsOfLine;
        const auto sizes = ship.at(x);
        for (std::size_t j = 0; j < motions.size(); ++j)
            plot.series[j].at.emplace_back(x, sizes[motions[j].index]);
    }
    for (const Motion& m : motions) {
        report::XyPlot::Series published{m.name + ", published", true, {}};
        for (const Point& p : points) published.at.emplace_back(p.x, table.at(m.column, p.row));
        plot.series.push_back(std::move(published));
    }
    return plot;
}

/// Roll, which resonates, has a plot of its own.
void addPlots(ValidationOutcome& outcome, const RaoCase& c, const ReferenceTable& table,
              const std::vector<Point>& points, const HullInWaves& ship) {
    std::vector<Motion> roll, others;
    for (const Motion& m : c.motions) (m.name == "roll" ? roll : others).push_back(m);
    for (const auto& motions : {others, roll})
        if (!motions.empty()) outcome.plots.push_back(plotOf(c, motions, table, points, ship));
}

}  // namespace

ValidationOutcome runRaoCase(const ValidationContext& context, Reader& in) {
    const RaoCase c = readCase(in);
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto form = readHullFile(context.reference(c.hull).string());
    if (!form) return outcome.trouble = form.error(), outcome;
    const auto table = ReferenceTable::read(context.reference(c.file));
    if (!table) return outcome.trouble = table.error(), outcome;
    const std::vector<Point> points = pointsOf(c, *table);
    if (points.empty()) return outcome.trouble = c.file + ": has no rows of this case", outcome;
    const HullInWaves ship(c.withoutEnds ? withoutEnds(*form) : *form, c);
    for (const Motion& m : c.motions) addRows(outcome, m, *table, points, ship);
    addPlots(outcome, c, *table, points, ship);
    return outcome;
}

}  // namespace sagara::tools
