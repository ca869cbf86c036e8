#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/assess/MissionContext.h"
#include "core/assess/Observation.h"
#include "core/assess/TaskZone.h"
#include "core/base/Config.h"

namespace sagara::core {

/// Points taken off, with what a trainee needs to see why.
struct Deduction {
    SimTime time;
    NorthEast place;
    double value = 0.0;  ///< SI; the worst of the episode
    double limit = 0.0;  ///< SI
    double points = 0.0;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.time.us, self.place, self.value, self.limit, self.points);
    }
};

/// What a criterion remembers. An episode is open while the limit is broken, and five seconds more.
struct CriterionMemory {
    double lost = 0.0;    ///< points so far
    bool broken = false;  ///< a criterion that fails the run was broken
    bool open = false;
    Deduction worst;      ///< of the open episode; its time is when the episode began
    double excess = 0.0;  ///< how far `worst` is beyond its limit
    SimTime lastBroken;
    bool begun = false;  ///< the criterion's own notes; their meaning is in its file
    double note = 0.0;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.lost, self.broken, self.open, self.worst, self.excess, self.lastBroken.us, self.begun,
           self.note);
    }
};

/// How a value is shown to people: factor from SI and unit.
struct Display {
    const char* quantity;  ///< "cross-track distance"
    double perUnit;        ///< SI value of one unit
    const char* unit;
};

/// What the rubric allows a ship here and now.
struct Limits {
    double speedOverGround_mps = 0.0;  ///< at most; 0: no limit
    double underKeel_m = 0.0;          ///< at least
};

/// One limit of the rubric: what it weighs at most and what each breach costs. Immutable; its memory is in
/// State.
class Criterion {
public:
    struct Terms {
        std::string id;
        std::string title;
        double weight = 0.0;  ///< most points it can cost
        double points = 0.0;  ///< of one breach
        bool fails = false;   ///< a breach fails the run
    };
    explicit Criterion(Terms terms) : m_terms(std::move(terms)) {}
    virtual ~Criterion() = default;
    const Terms& terms() const { return m_terms; }
    virtual Display display() const = 0;
    /// Where it holds, if not everywhere.
    virtual std::vector<TaskZone> zones() const { return {}; }
    /// Narrows `limits` to what this criterion allows a ship at this place.
    virtual void narrow(Limits& limits, const Observation& now, const RouteProgress& route) const;

    /// At every observation. Deductions are appended to `out`.
    virtual void observe(const Observation& now, const RouteProgress& route, CriterionMemory& memory,
                         std::vector<Deduction>& out) const;
    virtual void happened(const Happening& happening, CriterionMemory& memory,
                          std::vector<Deduction>& out) const;
    /// At the end of the run.
    virtual void close(SimTime time, CriterionMemory& memory, std::vector<Deduction>& out) const;

protected:
    /// Takes points off, as far as the weight still holds them.
    void deduct(Deduction deduction, CriterionMemory& memory, std::vector<Deduction>& out) const;

private:
    Terms m_terms;
};

/// A criterion on something that lasts. Each episode is one deduction: the points of a breach, and again for
/// every half minute it goes on.
class EpisodeCriterion : public Criterion {
public:
    using Criterion::Criterion;
    void observe(const Observation& now, const RouteProgress& route, CriterionMemory& memory,
                 std::vector<Deduction>& out) const final;
    void close(SimTime time, CriterionMemory& memory, std::vector<Deduction>& out) const final;

protected:
    struct Measure {
        bool broken = false;
        double value = 0.0;
        double limit = 0.0;
        double excess = 0.0;  ///< to compare two breaches: larger is worse
    };
    virtual Measure measure(const Observation& now, const RouteProgress& route,
                            CriterionMemory& memory) const = 0;
};

/// Reads one criterion by its "kind": see the registry in Criterion.cpp.
std::unique_ptr<const Criterion> readCriterion(const config::Node& node, const MissionContext& context);

}  // namespace sagara::core
