#include "core/vessel/Particulars.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/Config.h"
#include "core/base/Units.h"
#include "core/vessel/Estimate.h"
#include "core/vessel/EstimatedGroups.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {
namespace {

using nlohmann::ordered_json;

class Checker {
public:
    explicit Checker(config::Problems& problems) : m_problems(problems) {}
    void number(const char* field, double value, double low, double high, const char* unit) {
        if (value >= low && value <= high) return;
        m_problems.add({field, "is " + config::formatNumber(value),
                        config::formatNumber(low) + " to " + config::formatNumber(high) +
                            (*unit ? std::string(" ").append(unit) : std::string())});
    }
    void that(bool ok, const char* field, double value, const std::string& expected) {
        if (!ok) m_problems.add({field, "is " + config::formatNumber(value), expected});
    }

private:
    config::Problems& m_problems;
};

double rounded(double value, double step) { return std::round(value / step) * step; }

std::string kindNames() {
    std::string names;
    for (const ShipKind& kind : kShipKinds)
        names += (names.empty() ? "one of " : ", ") + std::string(kind.name);
    return names;
}

void checkSizes(const Particulars& p, config::Problems& problems) {
    Checker check(problems);
    if (!config::isId(p.id))
        problems.add(
            {"id", "is \"" + p.id + "\"", "1 to 60 small letters, digits and '-', such as coaster-90"});
    if (p.name.empty()) problems.add({"name", "is empty", "the name people choose her by"});
    if (!findShipKind(p.kind)) problems.add({"kind", "is \"" + p.kind + "\"", kindNames()});
    check.number("lengthOverall_m", p.lengthOverall_m, 8.0, 420.0, "m");
    check.number("lengthBp_m", p.lengthBp_m, 7.0, 400.0, "m");
    check.number("beam_m", p.beam_m, 2.0, 75.0, "m");
    check.number("draught_m", p.draught_m, 0.5, 26.0, "m");
    check.number("speed_mps", p.speed_mps, 2.0, 25.0, "m/s");
    if (p.power_W) check.number("power_W", *p.power_W, 2e4, 1.2e8, "W");
    check.number("shafts", p.shafts, 1, 4, "");
    check.number("rudders", p.rudders, 1, 4, "");
    if (!problems.empty()) return;
    check.that(p.lengthBp_m <= p.lengthOverall_m, "lengthBp_m", p.lengthBp_m,
               "at most length overall, " + config::formatNumber(p.lengthOverall_m) + " m");
    check.that(p.lengthBp_m >= 0.8 * p.lengthOverall_m, "lengthBp_m", p.lengthBp_m,
               "at least 0.8 of length overall, " +
                   config::formatNumber(rounded(0.8 * p.lengthOverall_m, 0.1)) + " m");
    const double slender = p.lengthBp_m / p.beam_m, flat = p.beam_m / p.draught_m;
    check.that(slender >= 2.2 && slender <= 14.0, "beam_m", p.beam_m,
               config::formatNumber(rounded(p.lengthBp_m / 14.0, 0.1)) + " to " +
                   config::formatNumber(rounded(p.lengthBp_m / 2.2, 0.1)) + " m for this length");
    check.that(flat >= 1.5 && flat <= 8.0, "draught_m", p.draught_m,
               config::formatNumber(rounded(p.beam_m / 8.0, 0.1)) + " to " +
                   config::formatNumber(rounded(p.beam_m / 1.5, 0.1)) + " m for this beam");
    const double block = p.volume_m3() / (p.lengthBp_m * p.beam_m * p.draught_m);
    if (p.displacement_m3.has_value() == p.blockCoefficient.has_value()) {
        problems.add(
            {"displacement_m3", "and block coefficient are both given or both missing", "one of the two"});
    } else {
        const double box_m3 = p.lengthBp_m * p.beam_m * p.draught_m;
        check.that(block >= 0.30 && block <= 0.90, p.displacement_m3 ? "displacement_m3" : "blockCoefficient",
                   p.displacement_m3 ? *p.displacement_m3 : block,
                   p.displacement_m3 ? config::formatNumber(std::round(0.30 * box_m3)) + " to " +
                                           config::formatNumber(std::round(0.90 * box_m3)) +
                                           " m3, a block coefficient of 0.3 to 0.9"
                                     : std::string("0.3 to 0.9"));
    }
    if (p.depth_m)
        check.number("depth_m", *p.depth_m, rounded(1.05 * p.draught_m, 0.01),
                     rounded(5.0 * p.draught_m, 0.01), "m");
    if (p.metacentricHeight_m)
        check.number("metacentricHeight_m", *p.metacentricHeight_m, 0.1, rounded(0.4 * p.beam_m, 0.01), "m");
    if (p.rudderArea_m2) {
        const double plane_m2 = p.lengthBp_m * p.draught_m;
        check.number("rudderArea_m2", *p.rudderArea_m2, rounded(0.005 * plane_m2, 0.01),
                     rounded(0.1 * plane_m2, 0.01), "m2");
    }
    if (p.bowThruster_W) check.number("bowThruster_W", *p.bowThruster_W, 5e3, 5e6, "W");
    if (p.propellerDiameter_m)
        check.number("propellerDiameter_m", *p.propellerDiameter_m, rounded(0.3 * p.draught_m, 0.01),
                     rounded(std::min(12.0, 0.95 * p.draught_m), 0.01), "m");
}

/// What no ship does: less than friction, or more than a planing boat.
void checkPower(const Particulars& p, const estimate::Form& form, const estimate::Drive& drive,
                config::Problems& problems) {
    const double friction_N = estimate::frictionalResistance_N(form, p.speed_mps);
    const double weight_N = form.mass_kg() * kGravity_mps2;
    const double most_N = std::max(0.25 * weight_N, 12.0 * friction_N);
    const ShipKind& kind = *findShipKind(p.kind);
    const auto powerFor = [&](double resistance_N) {
        return estimate::powerFor_W(resistance_N, p, kind, form);
    };
    const auto kilowatts = [](double W) { return config::formatNumber(std::ceil(1e-3 * W)) + " kW"; };
    const auto say = [&](const std::string& expected) {
        problems.add({"power_W", "is " + kilowatts(*p.power_W), expected});
    };
    if (drive.resistance_N < 0.95 * friction_N)
        say("at least " + kilowatts(powerFor(0.95 * friction_N)) +
            ": the friction of the hull alone takes that at this speed");
    else if (drive.resistance_N > most_N)
        say("at most about " + kilowatts(powerFor(most_N)) + " for this ship at this speed");
}

}  // namespace

const ShipKind* findShipKind(std::string_view name) {
    for (const ShipKind& kind : kShipKinds)
        if (name == kind.name) return &kind;
    return nullptr;
}

double powerForResistance_W(const Particulars& particulars) {
    Particulars p = particulars;
    p.power_W.reset();
    const ShipKind& kind = *findShipKind(p.kind);
    return estimate::driveOf(p, kind, estimate::formOf(p, kind)).power_W;
}

Result<std::string, config::Problems> vesselFromParticulars(const Particulars& p) {
    config::Problems problems("particulars");
    checkSizes(p, problems);
    if (!problems.empty()) return problems;
    const ShipKind& kind = *findShipKind(p.kind);
    const estimate::Form form = estimate::formOf(p, kind);
    if (!p.power_W && !holtropHolds(estimate::holtropHullOf(p, kind, form), p.speed_mps))
        problems.add(
            {"power_W", "is not given",
             "the engine power: this ship is outside the ships whose resistance the regression knows "
             "(length 3.9 to 15 beams, beam 2.1 to 4 draughts, prismatic coefficient 0.55 to 0.85, "
             "Froude number to 0.45)"});
    if (!problems.empty()) return problems;
    const estimate::Drive drive = estimate::driveOf(p, kind, form);
    if (p.power_W) checkPower(p, form, drive, problems);
    if (!problems.empty()) return problems;
    const std::string text = estimate::documentOf(p, kind, form, drive).dump(2) + "\n";
    const auto loaded = loadVessel(p.id, text);
    if (!loaded) return loaded.error();
    return text;
}

}  // namespace sagara::core
