#include "core/assess/PassageCriteria.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

bool anchorLetGo(const Observation& now) {
    return std::any_of(now.anchors.begin(), now.anchors.end(),
                       [](const AnchorObservation& a) { return a.down; });
}

class CrossTrackCriterion final : public EpisodeCriterion {
public:
    CrossTrackCriterion(Terms terms, const Route& route, double from_m)
        : EpisodeCriterion(std::move(terms)), m_from_m(from_m) {
        for (const Route::Waypoint& w : route.waypoints)
            m_limits.push_back({w.portLimit_m, w.starboardLimit_m});
    }
    Display display() const override { return {"distance off track", kNauticalMile_m, "M"}; }

protected:
    Measure measure(const Observation& now, const RouteProgress& route,
                    CriterionMemory& memory) const override {
        if (anchorLetGo(now)) memory.begun = true;  // over: she lies to her anchor
        if (memory.begun || route.along_m < m_from_m) return {};
        const Limits& limits = m_limits[std::min<std::size_t>(route.leg, m_limits.size() - 1)];
        const double limit_m = route.offTrack_m < 0.0 ? limits.port_m : limits.starboard_m;
        const double off_m = std::abs(route.offTrack_m);
        return {off_m > limit_m, off_m, limit_m, off_m / limit_m};
    }

private:
    struct Limits {
        double port_m;
        double starboard_m;
    };
    std::vector<Limits> m_limits;
    double m_from_m;
};

constexpr double kNone_mps = 1e9;  // where no zone holds

class SpeedLimitCriterion final : public EpisodeCriterion {
public:
    SpeedLimitCriterion(Terms terms, std::vector<SpeedZone> zones)
        : EpisodeCriterion(std::move(terms)), m_zones(std::move(zones)) {}
    Display display() const override { return {"speed over ground", kKnot_mps, "kn"}; }
    std::vector<TaskZone> zones() const override {
        std::vector<TaskZone> circles;  // legs are on the chart with the route
        for (const SpeedZone& zone : m_zones) {
            if (zone.circle) circles.push_back(TaskZone::circle(zone.centre, zone.radius_m));
        }
        return circles;
    }
    void narrow(Limits& limits, const Observation& now, const RouteProgress& route) const override {
        const double here_mps = lowestSpeed_mps(m_zones, now.position, route.leg, kNone_mps);
        if (here_mps == kNone_mps) return;
        const double other_mps = limits.speedOverGround_mps;
        limits.speedOverGround_mps = other_mps == 0.0 ? here_mps : std::min(other_mps, here_mps);
    }

protected:
    Measure measure(const Observation& now, const RouteProgress& route, CriterionMemory&) const override {
        const double limit_mps = lowestSpeed_mps(m_zones, now.position, route.leg, kNone_mps);
        constexpr double kPen_mps = 0.1 * kKnot_mps;  // the display has one decimal
        const double speed_mps = length(now.overGround_mps);
        return {speed_mps > limit_mps + kPen_mps, speed_mps, limit_mps, speed_mps - limit_mps};
    }

private:
    std::vector<SpeedZone> m_zones;
};

/// Note: the time (us, so that it is exact) of the first line let go.
class TimeLimitCriterion final : public Criterion {
public:
    TimeLimitCriterion(Terms terms, const std::array<double, kLevels>& limit_s)
        : Criterion(std::move(terms)), m_limit_s(limit_s) {}
    Display display() const override { return {"time since the first line", 60.0, "min"}; }

    void observe(const Observation& now, const RouteProgress&, CriterionMemory& memory,
                 std::vector<Deduction>& out) const override {
        // `open` holds whether the clock runs, `note` the lines at the start until then and the starting time
        // after.
        if (!memory.begun) {
            memory.begun = true;
            memory.note = now.linesFast;
        }
        if (!memory.open && (now.linesFast != static_cast<std::uint8_t>(memory.note) || memory.note == 0.0)) {
            memory.open = true;
            memory.note = static_cast<double>(now.time.us);
        }
        if (!memory.open || memory.broken) return;
        const SimTime begun{static_cast<std::int64_t>(memory.note)};
        const double limit_s = m_limit_s[static_cast<std::size_t>(now.level - 1)],
                     taken_s = (now.time - begun).seconds();
        if (taken_s <= limit_s) return;
        deduct({now.time, now.position, taken_s, limit_s, terms().points}, memory, out);
        memory.broken = true;
    }

private:
    std::array<double, kLevels> m_limit_s;
};

}  // namespace

std::unique_ptr<const Criterion> makeCrossTrackCriterion(Criterion::Terms terms, config::Reader& in,
                                                         const MissionContext& context) {
    const std::size_t from = context.readWaypoint(in, "fromWaypoint");
    const double from_m = context.route.waypoints.empty() ? 0.0 : context.path.alongOf(from);
    return std::make_unique<CrossTrackCriterion>(std::move(terms), context.route, from_m);
}

std::unique_ptr<const Criterion> makeSpeedLimitCriterion(Criterion::Terms terms, config::Reader& in,
                                                         const MissionContext& context) {
    return std::make_unique<SpeedLimitCriterion>(std::move(terms), context.readSpeedZones(in, "zones"));
}

std::unique_ptr<const Criterion> makeTimeLimitCriterion(Criterion::Terms terms, config::Reader& in,
                                                        const MissionContext&) {
    std::array<double, kLevels> limit_s{};
    const std::vector<double> minutes = in.numbers("limit_min", kLevels, {0.5, 24.0 * 60.0, "min"});
    for (std::size_t i = 0; i < limit_s.size(); ++i) limit_s[i] = 60.0 * minutes[i];
    return std::make_unique<TimeLimitCriterion>(std::move(terms), limit_s);
}

}  // namespace sagara::core
