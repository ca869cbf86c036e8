#include "core/assess/SafetyCriteria.h"

#include <algorithm>

namespace sagara::core {
namespace {

class UnderKeelCriterion final : public EpisodeCriterion {
public:
    UnderKeelCriterion(Terms terms, double limit_m)
        : EpisodeCriterion(std::move(terms)), m_limit_m(limit_m) {}
    Display display() const override { return {"under-keel clearance", 1.0, "m"}; }
    void narrow(Limits& limits, const Observation&, const RouteProgress&) const override {
        limits.underKeel_m = std::max(limits.underKeel_m, m_limit_m);
    }

protected:
    Measure measure(const Observation& now, const RouteProgress&, CriterionMemory&) const override {
        return {now.underKeel_m < m_limit_m, now.underKeel_m, m_limit_m, -now.underKeel_m};
    }

private:
    double m_limit_m;
};

class PassingDistanceCriterion final : public EpisodeCriterion {
public:
    PassingDistanceCriterion(Terms terms, double limit_m, std::size_t fromLeg, std::size_t toLeg)
        : EpisodeCriterion(std::move(terms)), m_limit_m(limit_m), m_fromLeg(fromLeg), m_toLeg(toLeg) {}
    Display display() const override { return {"distance to another ship", 1.0, "m"}; }

protected:
    Measure measure(const Observation& now, const RouteProgress& route, CriterionMemory&) const override {
        const bool here = route.leg >= m_fromLeg && route.leg <= m_toLeg;
        return {here && now.clearOfShips_m < m_limit_m, now.clearOfShips_m, m_limit_m, -now.clearOfShips_m};
    }

private:
    double m_limit_m;
    std::size_t m_fromLeg;
    std::size_t m_toLeg;
};

}  // namespace

std::unique_ptr<const Criterion> makeUnderKeelCriterion(Criterion::Terms terms, config::Reader& in,
                                                        const MissionContext&) {
    const double limit_m = in.number("limit_m", {0.0, 50.0, "m"});
    return std::make_unique<UnderKeelCriterion>(std::move(terms), limit_m);
}

std::unique_ptr<const Criterion> makePassingDistanceCriterion(Criterion::Terms terms, config::Reader& in,
                                                              const MissionContext& context) {
    const double limit_m = in.number("limit_m", {1.0, kShipsLimit_m, "m"});
    // A leg is named by the waypoint it ends at, so the legs after a waypoint begin one later.
    const std::size_t from = in.has("fromWaypoint") ? context.readWaypoint(in, "fromWaypoint") + 1 : 0;
    const std::size_t to =
        in.has("toWaypoint") ? context.readWaypoint(in, "toWaypoint") : context.route.waypoints.size();
    if (in.sound() && to < from) in.problem("toWaypoint", "is not after fromWaypoint", "a later one");
    return std::make_unique<PassingDistanceCriterion>(std::move(terms), limit_m, from, to);
}

}  // namespace sagara::core
