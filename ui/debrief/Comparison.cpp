#include "ui/debrief/Comparison.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "ui/chart/Format.h"
#include "ui/debrief/TimeAxis.h"

namespace sagara::ui {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("sagara::ui::Comparison", text); }
QString dash() { return QStringLiteral("–"); }

QString sign(double value) {
    return value > 0.0 ? QStringLiteral("+") : value < 0.0 ? QStringLiteral("−") : QString();
}

QString difference(double a, double b, int decimals, const QString& unit) {
    const double by = b - a;
    const QString number = chart::number(std::abs(by), decimals);
    return (number.toDouble() == 0.0 ? QString() : sign(by)) + number + QLatin1Char(' ') + unit;
}

QString valueAt(double value, int decimals, const QString& unit, std::optional<double> time_s) {
    const QString text = chart::number(value, decimals) + QLatin1Char(' ') + unit;
    return time_s ? tr("%1, %2").arg(text, axisTime(*time_s)) : text;
}

core::SimTime moment(double time_s) { return {std::llround(1e6 * time_s)}; }

ComparisonRow row(const QString& name, double a, double b, int decimals, const QString& unit,
                  std::optional<double> a_s = {}, std::optional<double> b_s = {}) {
    ComparisonRow r{name,
                    valueAt(a, decimals, unit, a_s),
                    valueAt(b, decimals, unit, b_s),
                    difference(a, b, decimals, unit),
                    {}};
    if (b_s) r.moment = moment(*b_s);
    return r;
}

ComparisonRow taskRow(const QString& title, std::optional<double> a_s, std::optional<double> b_s) {
    ComparisonRow r{
        title, a_s ? axisTime(*a_s) : tr("not done"), b_s ? axisTime(*b_s) : tr("not done"), dash(), {}};
    if (a_s && b_s) r.difference = sign(*b_s - *a_s) + axisTime(std::abs(*b_s - *a_s));
    if (b_s ? b_s : a_s) r.moment = moment(b_s ? *b_s : *a_s);
    return r;
}

}  // namespace

RunFigures figuresOf(const core::World& world, const std::vector<core::TrackSample>& track,
                     const std::vector<core::Event>& events, core::SimTime from) {
    RunFigures f;
    f.leastUnderKeel_m = f.closestShore_m = 1e9;
    core::RouteProgress progress;
    std::optional<core::NorthEast> last;
    const bool routed = world.route.waypoints.size() >= 2;
    for (const core::TrackSample& sample : track) {
        if (sample.ships.empty()) continue;
        const core::ShipSample& s = sample.ships[0];
        const core::Observation& o = s.observation;
        const double t = core::timeOfTick(sample.tick).seconds();
        if (routed) core::follow(world.path, s.motion.position(), progress);
        if (core::timeOfTick(sample.tick) < from) continue;
        f.until_s = t;
        f.score = s.score;
        f.mostSpeed_mps = std::max(f.mostSpeed_mps, core::length(o.overGround_mps));
        if (o.underKeel_m < f.leastUnderKeel_m) f.leastUnderKeel_m = o.underKeel_m, f.leastUnderKeel_s = t;
        if (o.clearOfShore_m < f.closestShore_m) f.closestShore_m = o.clearOfShore_m, f.closestShore_s = t;
        if (o.clearOfShips_m < core::kShipsLimit_m &&
            (!f.closestShips_m || o.clearOfShips_m < *f.closestShips_m))
            f.closestShips_m = o.clearOfShips_m, f.closestShips_s = t;
        if (routed && std::abs(progress.offTrack_m) > f.mostOffTrack_m)
            f.mostOffTrack_m = std::abs(progress.offTrack_m), f.mostOffTrack_s = t;
        if (last) f.run_m += core::distance(*last, s.motion.position());
        last = s.motion.position();
    }
    f.tasks_s.resize(world.mission.tasks.size());
    for (const core::Event& e : events) {
        const auto i = static_cast<std::size_t>(e.index);
        if (e.kind == core::EventKind::TaskDone && i < f.tasks_s.size()) f.tasks_s[i] = e.time().seconds();
    }
    return f;
}

TrackDifference differenceOf(const std::vector<core::TrackSample>& a,
                             const std::vector<core::TrackSample>& b) {
    TrackDifference d;
    auto other = a.begin();
    for (const core::TrackSample& sample : b) {
        while (other != a.end() && other->tick < sample.tick) ++other;
        if (other == a.end()) break;
        if (other->tick != sample.tick || sample.ships.empty() || other->ships.empty()) continue;
        const double apart_m =
            core::distance(other->ships[0].motion.position(), sample.ships[0].motion.position());
        const double t = core::timeOfTick(sample.tick).seconds();
        if (apart_m > d.most_m) d.most_m = apart_m, d.most_s = t;
        d.atEnd_m = apart_m;
        d.atEnd_s = t;
    }
    return d;
}

std::vector<ComparisonRow> comparisonOf(const core::World& world, const RunFigures& a, const RunFigures& b,
                                        const TrackDifference& tracks) {
    std::vector<ComparisonRow> rows;
    rows.push_back({tr("Sailed until"),
                    axisTime(a.until_s),
                    axisTime(b.until_s),
                    sign(b.until_s - a.until_s) + axisTime(std::abs(b.until_s - a.until_s)),
                    {}});
    rows.push_back(row(tr("Score"), a.score, b.score, 0, tr("points")));
    for (std::size_t i = 0; i < world.mission.tasks.size(); ++i)
        rows.push_back(
            taskRow(QString::fromStdString(world.mission.tasks[i]->title()), a.tasks_s[i], b.tasks_s[i]));
    if (a.closestShips_m && b.closestShips_m) {
        rows.push_back(row(tr("Closest to another ship"), *a.closestShips_m, *b.closestShips_m, 0, tr("m"),
                           a.closestShips_s, b.closestShips_s));
    } else {
        const auto text = [](const RunFigures& f) {
            return f.closestShips_m ? valueAt(*f.closestShips_m, 0, tr("m"), f.closestShips_s)
                                    : tr("none within 5 km");
        };
        rows.push_back({tr("Closest to another ship"), text(a), text(b), dash(), {}});
    }
    const auto shore = [](const RunFigures& f) {
        return f.closestShore_m >= core::kShoreLimit_m
                   ? tr("over 100 m")
                   : valueAt(f.closestShore_m, 0, tr("m"), f.closestShore_s);
    };
    rows.push_back({tr("Closest to shore or quay"), shore(a), shore(b),
                    std::max(a.closestShore_m, b.closestShore_m) < core::kShoreLimit_m
                        ? difference(a.closestShore_m, b.closestShore_m, 0, tr("m"))
                        : dash(),
                    moment(b.closestShore_s)});
    rows.push_back(row(tr("Least under the keel"), a.leastUnderKeel_m, b.leastUnderKeel_m, 1, tr("m"),
                       a.leastUnderKeel_s, b.leastUnderKeel_s));
    if (world.route.waypoints.size() >= 2)
        rows.push_back(row(tr("Most off the track"), a.mostOffTrack_m, b.mostOffTrack_m, 0, tr("m"),
                           a.mostOffTrack_s, b.mostOffTrack_s));
    rows.push_back(row(tr("Highest speed over ground"), a.mostSpeed_mps / core::kKnot_mps,
                       b.mostSpeed_mps / core::kKnot_mps, 1, tr("kn")));
    rows.push_back(row(tr("Way over the ground"), a.run_m / core::kNauticalMile_m,
                       b.run_m / core::kNauticalMile_m, 2, tr("M")));
    rows.push_back({tr("Farthest apart at the same time"), dash(), dash(),
                    valueAt(tracks.most_m, 0, tr("m"), tracks.most_s), moment(tracks.most_s)});
    rows.push_back({tr("Apart at the end of both"), dash(), dash(),
                    valueAt(tracks.atEnd_m, 0, tr("m"), tracks.atEnd_s), moment(tracks.atEnd_s)});
    return rows;
}

}  // namespace sagara::ui
