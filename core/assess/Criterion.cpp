#include "core/assess/Criterion.h"

#include <algorithm>
#include <cmath>

#include "core/assess/AnchorCriteria.h"
#include "core/assess/DamageCriteria.h"
#include "core/assess/PassageCriteria.h"
#include "core/assess/SafetyCriteria.h"

namespace sagara::core {
namespace {

constexpr double kEpisodeEnds_s = 5.0;
constexpr double kCountsAgain_s = 30.0;

using Make = std::unique_ptr<const Criterion> (*)(Criterion::Terms terms, config::Reader& in,
                                                  const MissionContext& context);

}  // namespace

void Criterion::narrow(Limits&, const Observation&, const RouteProgress&) const {}
void Criterion::observe(const Observation&, const RouteProgress&, CriterionMemory&,
                        std::vector<Deduction>&) const {}
void Criterion::happened(const Happening&, CriterionMemory&, std::vector<Deduction>&) const {}
void Criterion::close(SimTime, CriterionMemory&, std::vector<Deduction>&) const {}

void Criterion::deduct(Deduction deduction, CriterionMemory& memory, std::vector<Deduction>& out) const {
    deduction.points = std::min(deduction.points, m_terms.weight - memory.lost);
    memory.lost += deduction.points;
    if (m_terms.fails) memory.broken = true;
    out.push_back(deduction);
}

void EpisodeCriterion::observe(const Observation& now, const RouteProgress& route, CriterionMemory& memory,
                               std::vector<Deduction>& out) const {
    const Measure m = measure(now, route, memory);
    if (m.broken) {
        if (!memory.open || m.excess > memory.excess) {
            memory.worst = {memory.open ? memory.worst.time : now.time, now.position, m.value, m.limit, 0.0};
            memory.excess = m.excess;
        }
        memory.open = true;
        memory.lastBroken = now.time;
        if (terms().fails) memory.broken = true;
    } else if (memory.open && (now.time - memory.lastBroken).seconds() > kEpisodeEnds_s) {
        close(now.time, memory, out);
    }
}

void EpisodeCriterion::close(SimTime, CriterionMemory& memory, std::vector<Deduction>& out) const {
    if (!memory.open) return;
    memory.open = false;
    Deduction deduction = memory.worst;
    const double lasted_s = (memory.lastBroken - deduction.time).seconds();
    deduction.points = terms().points * (1.0 + std::floor(lasted_s / kCountsAgain_s));
    deduct(deduction, memory, out);
}

std::unique_ptr<const Criterion> readCriterion(const config::Node& node, const MissionContext& context) {
    config::Reader in(node);
    Criterion::Terms terms;
    terms.id = in.id("id");
    terms.title = in.text("title");
    terms.weight = in.number("weight", {0.0, 100.0, "points"});
    terms.points = in.number("points", {0.0, 100.0, "points"});
    terms.fails = in.flagOr("fails", false);
    // A new kind of criterion: its pair of files and one line here.
    const auto make = in.choiceIfKnown<Make>("kind", {{"cross-track", makeCrossTrackCriterion},
                                                      {"speed-limit", makeSpeedLimitCriterion},
                                                      {"time-limit", makeTimeLimitCriterion},
                                                      {"under-keel", makeUnderKeelCriterion},
                                                      {"passing-distance", makePassingDistanceCriterion},
                                                      {"contact-speed", makeContactSpeedCriterion},
                                                      {"contact-energy", makeContactEnergyCriterion},
                                                      {"collision", makeCollisionCriterion},
                                                      {"grounding", makeGroundingCriterion},
                                                      {"parted", makePartedCriterion},
                                                      {"anchor-place", makeAnchorPlaceCriterion},
                                                      {"let-go-speed", makeLetGoSpeedCriterion},
                                                      {"anchor-drag", makeAnchorDragCriterion}});
    if (!make) return nullptr;
    auto criterion = (*make)(std::move(terms), in, context);
    in.rejectUnknownKeys();
    return criterion;
}

}  // namespace sagara::core
