#include "core/assess/AnchorCriteria.h"

#include <algorithm>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

class AnchorPlaceCriterion final : public Criterion {
public:
    AnchorPlaceCriterion(Terms terms, NorthEast place, double limit_m)
        : Criterion(std::move(terms)), m_place(place), m_limit_m(limit_m) {}
    Display display() const override { return {"distance of the anchor from the mark", 1.0, "m"}; }
    std::vector<TaskZone> zones() const override { return {TaskZone::circle(m_place, m_limit_m)}; }
    void happened(const Happening& h, CriterionMemory& memory, std::vector<Deduction>& out) const override {
        const double off_m = distance(h.place, m_place);
        if (h.kind != Happening::Kind::AnchorLetGo || off_m <= m_limit_m) return;
        deduct({h.time, h.place, off_m, m_limit_m, terms().points}, memory, out);
    }

private:
    NorthEast m_place;
    double m_limit_m;
};

class LetGoSpeedCriterion final : public Criterion {
public:
    LetGoSpeedCriterion(Terms terms, double least_mps, double most_mps)
        : Criterion(std::move(terms)), m_least_mps(least_mps), m_most_mps(most_mps) {}
    Display display() const override { return {"sternway at let go", kKnot_mps, "kn"}; }
    void happened(const Happening& h, CriterionMemory& memory, std::vector<Deduction>& out) const override {
        if (h.kind != Happening::Kind::AnchorLetGo) return;
        const double astern_mps = -h.speed_mps;
        if (astern_mps >= m_least_mps && astern_mps <= m_most_mps) return;
        const double limit_mps = astern_mps < m_least_mps ? m_least_mps : m_most_mps;
        deduct({h.time, h.place, astern_mps, limit_mps, terms().points}, memory, out);
    }

private:
    double m_least_mps;
    double m_most_mps;
};

class AnchorDragCriterion final : public Criterion {
public:
    AnchorDragCriterion(Terms terms, double limit_m) : Criterion(std::move(terms)), m_limit_m(limit_m) {}
    Display display() const override { return {"distance dragged", 1.0, "m"}; }
    void observe(const Observation& now, const RouteProgress&, CriterionMemory& memory,
                 std::vector<Deduction>& out) const override {
        double dragged_m = 0.0;
        bool down = false;
        for (const AnchorObservation& a : now.anchors) {
            if (!a.down) continue;
            down = true;
            dragged_m = std::max(dragged_m, a.dragged_m);
        }
        if (!down) memory.begun = false;  // a new attempt is graded anew
        if (memory.begun || dragged_m <= m_limit_m) return;
        memory.begun = true;
        deduct({now.time, now.position, dragged_m, m_limit_m, terms().points}, memory, out);
    }

private:
    double m_limit_m;
};

}  // namespace

std::unique_ptr<const Criterion> makeAnchorPlaceCriterion(Criterion::Terms terms, config::Reader& in,
                                                          const MissionContext& context) {
    const NorthEast place = context.readPlace(in, "at");
    const double limit_m = in.number("limit_m", {1.0, 2000.0, "m"});
    return std::make_unique<AnchorPlaceCriterion>(std::move(terms), place, limit_m);
}

std::unique_ptr<const Criterion> makeLetGoSpeedCriterion(Criterion::Terms terms, config::Reader& in,
                                                         const MissionContext&) {
    const double least_mps = kKnot_mps * in.number("least_kn", {-5.0, 5.0, "kn"});
    const double most_mps = kKnot_mps * in.number("most_kn", {-5.0, 5.0, "kn"});
    if (in.sound() && most_mps < least_mps)
        in.problem("most_kn", "is less than least_kn", "at least as much");
    return std::make_unique<LetGoSpeedCriterion>(std::move(terms), least_mps, most_mps);
}

std::unique_ptr<const Criterion> makeAnchorDragCriterion(Criterion::Terms terms, config::Reader& in,
                                                         const MissionContext&) {
    const double limit_m = in.number("limit_m", {0.5, 500.0, "m"});
    return std::make_unique<AnchorDragCriterion>(std::move(terms), limit_m);
}

}  // namespace sagara::core
