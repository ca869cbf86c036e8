#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/vessel/EstimatedGroups.h"

namespace sagara::core::estimate {
namespace {

using Json = nlohmann::ordered_json;

/// The rudder amidships is a fin: the inflow turned by drift and yaw at the stern, straightened by the hull.
constexpr double kStraightening = 0.4, kFinLever = 0.71;  // KVLCC2, Yasukawa and Yoshimura (2015)
/// The set is used at its low-speed end at all speeds: see the source of the group.
constexpr double kHoldsFrom_mps = 30.0, kWholeBelow_mps = 29.5;

Json finTerms(const Form& f, const Drive& drive, const Rudders& r) {
    const double area_m2 = r.areaEach_m2 * static_cast<double>(r.across_m.size());
    const double force = 0.5 * kWater_kgpm3 * area_m2 * r.liftSlope_perRad * kStraightening *
                         (1.0 + r.raceShare * drive.addedRace());
    const double lever_m = kFinLever * f.length_m;
    return {{{"of", "|u| v"}, {"Y", neat(-force)}, {"N", neat(force * r.yawLever_m)}},
            {{"of", "|u| r"}, {"Y", neat(force * lever_m)}, {"N", neat(-force * lever_m * r.yawLever_m)}}};
}

}  // namespace

Json modelGroup(const Form& f, const Drive& drive, const Rudders& rudders) {
    const Derivatives d = derivativesOf(f);
    const double mass_kg = f.mass_kg();
    const double rollInertia = mass_kg * f.rollGyradius_m * f.rollGyradius_m;
    const double rollCritical =
        2.0 * std::sqrt(1.2 * rollInertia * mass_kg * kGravity_mps2 * f.metacentric_m);
    const double depth_m = 0.35 * f.draught_m;  // of the hull's side force below the waterline
    constexpr double kRollDamping = 0.05, kRollDampingUnderWay = 0.04;
    Json terms = Json::array();
    const auto lateral = [&](const char* of, double Y) {
        terms.push_back({{"of", of}, {"Y", neat(Y)}, {"K", neat(-depth_m * Y)}});
    };
    terms.push_back(
        {{"of", "u |u|"}, {"X", neat(-drive.resistance_N / (drive.speed_mps * drive.speed_mps))}});
    terms.push_back({{"of", "v r"}, {"X", neat(d.Xvr)}});
    terms.push_back({{"of", "v^2"}, {"X", neat(d.Xvv)}, {"turnsAstern", true}});
    lateral("|u| v", d.Yv);
    lateral("u r", d.Yr);
    terms.push_back({{"of", "|u| v"}, {"N", neat(d.Nv)}, {"turnsAstern", true}});
    terms.push_back({{"of", "|u| r"}, {"N", neat(d.Nr)}});
    for (Json& term : finTerms(f, drive, rudders)) terms.push_back(std::move(term));
    terms.push_back({{"of", "p"}, {"K", neat(-kRollDamping * rollCritical)}});
    terms.push_back({{"of", "|u| p"}, {"K", neat(-kRollDampingUnderWay * rollCritical / drive.speed_mps)}});

    Json model{{"kind", "polynomial"},
               {"source",
                "linear derivatives and added masses: Clarke, Gedling & Hine 1983; surge added mass: Soeding "
                "1982; X of v r: Hasegawa 1980, of v^2: Yoshimura & Masumoto 2012; rudder amidships as "
                "a fin with a straightening of 0.4; large drift and yaw by cross flow, see "
                "lowSpeedExtension, which is in "
                "force at all speeds; good to 20 to 30 % in turning; the drag of the rudder is not in it"},
               {"quality", "estimated"}};
    model["rigidBody"] = {{"mass_kg", neat(mass_kg)},
                          {"xG_m", 0.0},
                          {"zG_m", neat(f.draught_m - f.gravityHeight_m)},
                          {"Ixx_kgm2", neat(rollInertia)},
                          {"Izz_kgm2", neat(mass_kg * 0.0625 * f.length_m * f.length_m)}};
    model["addedMass"] = {{"Xudot", neat(d.Xudot)}, {"Yvdot", neat(d.Yvdot)},
                          {"Yrdot", neat(d.Yrdot)}, {"Kpdot", neat(-0.2 * rollInertia)},
                          {"Nvdot", neat(d.Nvdot)}, {"Nrdot", neat(d.Nrdot)}};
    model["terms"] = terms;
    model["published"] = {{"rudderYawLever_m", neat(rudders.yawLever_m)},
                          {"rudderRollLever_m", neat(0.5 * f.draught_m)},
                          {"thrust_N", neat(drive.resistance_N)},
                          {"atShaft_rps", neat(drive.shaft_rps)},
                          {"holdsFrom_mps", kHoldsFrom_mps},
                          {"holdsTo_mps", kHoldsFrom_mps}};
    model["lowSpeedExtension"] = {
        {"wholeBelow_mps", kWholeBelow_mps},
        {"crossFlowDrag", neat(d.crossFlowDrag)},
        {"source",
         "cross-flow drag coefficient of Kijima et al. 1990 in pure drift, 2.5 T (1 - Cb) / B + 0.5; there "
         "is "
         "no published set, so that propellers work by KT(J) and rudders in their race at every speed"}};
    return model;
}

}  // namespace sagara::core::estimate
