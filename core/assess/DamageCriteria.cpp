#include "core/assess/DamageCriteria.h"

namespace sagara::core {
namespace {

bool isBlow(const Happening& h) {
    return h.kind == Happening::Kind::Contact && h.contact != ContactKind::Ship;
}

class ContactSpeedCriterion final : public Criterion {
public:
    ContactSpeedCriterion(Terms terms, double limit_mps)
        : Criterion(std::move(terms)), m_limit_mps(limit_mps) {}
    Display display() const override { return {"speed of contact", 1.0, "m/s"}; }
    void happened(const Happening& h, CriterionMemory& memory, std::vector<Deduction>& out) const override {
        if (!isBlow(h) || h.speed_mps <= m_limit_mps) return;
        deduct({h.time, h.place, h.speed_mps, m_limit_mps, terms().points}, memory, out);
    }

private:
    double m_limit_mps;
};

class ContactEnergyCriterion final : public Criterion {
public:
    ContactEnergyCriterion(Terms terms, double limit_J) : Criterion(std::move(terms)), m_limit_J(limit_J) {}
    Display display() const override { return {"energy of contact", 1000.0, "kJ"}; }
    void happened(const Happening& h, CriterionMemory& memory, std::vector<Deduction>& out) const override {
        if (!isBlow(h) || h.energy_J <= m_limit_J) return;
        deduct({h.time, h.place, h.energy_J, m_limit_J, terms().points}, memory, out);
    }

private:
    double m_limit_J;
};

class CollisionCriterion final : public Criterion {
public:
    using Criterion::Criterion;
    Display display() const override { return {"speed of collision", 1.0, "m/s"}; }
    void happened(const Happening& h, CriterionMemory& memory, std::vector<Deduction>& out) const override {
        if (h.kind != Happening::Kind::Contact || h.contact != ContactKind::Ship) return;
        deduct({h.time, h.place, h.speed_mps, 0.0, terms().points}, memory, out);
    }
};

class GroundingCriterion final : public Criterion {
public:
    using Criterion::Criterion;
    Display display() const override { return {"speed of grounding", 1.0, "m/s"}; }
    void happened(const Happening& h, CriterionMemory& memory, std::vector<Deduction>& out) const override {
        if (h.kind == Happening::Kind::Grounding)
            deduct({h.time, h.place, h.speed_mps, 0.0, terms().points}, memory, out);
    }
};

class PartedCriterion final : public Criterion {
public:
    using Criterion::Criterion;
    Display display() const override { return {"parted", 1.0, ""}; }
    void happened(const Happening& h, CriterionMemory& memory, std::vector<Deduction>& out) const override {
        if (h.kind != Happening::Kind::LineParted && h.kind != Happening::Kind::CableParted) return;
        deduct({h.time, h.place, 1.0, 0.0, terms().points}, memory, out);
    }
};

}  // namespace

std::unique_ptr<const Criterion> makeContactSpeedCriterion(Criterion::Terms terms, config::Reader& in,
                                                           const MissionContext&) {
    const double limit_mps = in.number("limit_mps", {0.0, 10.0, "m/s"});
    return std::make_unique<ContactSpeedCriterion>(std::move(terms), limit_mps);
}
std::unique_ptr<const Criterion> makeContactEnergyCriterion(Criterion::Terms terms, config::Reader& in,
                                                            const MissionContext&) {
    const double limit_J = 1000.0 * in.number("limit_kJ", {0.0, 1e6, "kJ"});
    return std::make_unique<ContactEnergyCriterion>(std::move(terms), limit_J);
}
std::unique_ptr<const Criterion> makeCollisionCriterion(Criterion::Terms terms, config::Reader&,
                                                        const MissionContext&) {
    return std::make_unique<CollisionCriterion>(std::move(terms));
}
std::unique_ptr<const Criterion> makeGroundingCriterion(Criterion::Terms terms, config::Reader&,
                                                        const MissionContext&) {
    return std::make_unique<GroundingCriterion>(std::move(terms));
}
std::unique_ptr<const Criterion> makePartedCriterion(Criterion::Terms terms, config::Reader&,
                                                     const MissionContext&) {
    return std::make_unique<PartedCriterion>(std::move(terms));
}

}  // namespace sagara::core
