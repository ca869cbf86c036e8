#include "core/vessel/EstimatedGroups.h"

#include <algorithm>
#include <cmath>

#include "core/base/Config.h"
#include "core/base/Units.h"

namespace sagara::core::estimate {
namespace {

using Json = nlohmann::ordered_json;

Json marked(Json group, const std::string& source) {
    group["source"] = source;
    group["quality"] = "estimated";
    return group;
}

Json hullGroup(const Particulars& p, const Form& f) {
    return marked(
        {{"lengthOverall_m", f.lengthOverall_m},
         {"lengthBp_m", f.length_m},
         {"beam_m", f.beam_m},
         {"draught_m", f.draught_m},
         {"depth_m", neat(f.depth_m)},
         {"displacement_m3", neat(f.volume_m3)},
         {"waterDensity_kgpm3", kWater_kgpm3},
         {"metacentricHeight_m", neat(f.metacentric_m)},
         {"waterplaneCoefficient", neat(f.waterplane)},
         {"rollGyradius_m", neat(f.rollGyradius_m)},
         {"pitchGyradius_m", neat(0.25 * f.length_m)}},
        "lengths, beam, draught and displacement " +
            (p.source.empty() ? std::string("as entered") : "from " + p.source) + "; depth " +
            (p.depth_m ? "the same" : "usual for the type") +
            "; waterplane coefficient Schneekluth & Bertram 1998; GM " +
            (p.metacentricHeight_m ? "as the lengths"
                                   : "with KB by Morrish, BM from the waterplane, KG usual for the type") +
            "; roll gyradius from the roll period of the IMO 2008 IS Code; pitch gyradius 0.25 Lpp");
}

/// Engines of slower shafts drive them without a gear.
constexpr double kDirectBelow_rpm = 180.0;

Json propulsionGroup(const Particulars& p, const Form& f, const Drive& d,
                     const std::vector<double>& across_m) {
    static constexpr const char* kNames[4][4] = {
        {"centre", "", "", ""},
        {"port", "starboard", "", ""},
        {"port", "centre", "starboard", ""},
        {"port-outer", "port-inner", "starboard-inner", "starboard-outer"}};
    const double full_rpm = d.shaft_rps / kRpm_rps;
    const double ramp_s = std::clamp(0.25 * f.length_m, 8.0, 90.0);
    Json units = Json::array();
    for (std::size_t i = 0; i < across_m.size(); ++i) {
        Json unit{{"id", kNames[across_m.size() - 1][i]},
                  {"x_m", neat(-0.485 * f.length_m)},
                  {"y_m", neat(across_m[i])},
                  {"diameter_m", neat(d.diameter_m)},
                  {"wageningenB",
                   {{"blades", d.screw.blades},
                    {"areaRatio", neat(d.screw.areaRatio)},
                    {"pitchRatio", neat(d.screw.pitchRatio)}}},
                  {"wakeFraction", neat(d.wake)},
                  {"thrustDeduction", neat(d.deduction)},
                  {"shaftRate_rpmps", neat(std::clamp(full_rpm / ramp_s, 0.2, 200.0))},
                  {"reversingTime_s", neat(std::clamp(0.06 * f.length_m, 2.0, 25.0))}};
        unit["engine"] = {{"power_kW", neat(1e-3 * d.power_W / p.shafts)},
                          {"speed_rpm", neat(full_rpm * std::cbrt(1.0 / kServiceLoad))},
                          {"idle_rpm", neat(0.28 * full_rpm)}};
        if (full_rpm < kDirectBelow_rpm) unit["engine"]["startAir"] = {{"starts", 12}, {"refill_s", 300}};
        units.push_back(std::move(unit));
    }
    const auto step = [&](double share) { return neat(share * full_rpm); };
    const auto percent = [](double share) { return config::formatNumber(std::round(share * 100.0) / 100.0); };
    return marked({{"units", units},
                   {"telegraph_rpm",
                    {{"fullAstern", step(-0.80)},
                     {"halfAstern", step(-0.60)},
                     {"slowAstern", step(-0.45)},
                     {"deadSlowAstern", step(-0.32)},
                     {"deadSlowAhead", step(0.32)},
                     {"slowAhead", step(0.45)},
                     {"halfAhead", step(0.68)},
                     {"fullAhead", step(1.0)}}}},
                  "Wageningen B4 propeller, AE/A0 " + percent(d.screw.areaRatio) + " by Keller, P/D " +
                      percent(d.screw.pitchRatio) +
                      " of best efficiency (Oosterveld & van Oossanen 1975), taking 85 % of " +
                      config::formatNumber(std::round(1e-3 * d.power_W)) + " kW" +
                      (d.powerKnown ? "" : " (no power known: that for the resistance)") + " at " +
                      percent(p.speed_mps / kKnot_mps) +
                      " kn; wake Taylor 1933, thrust deduction Schoenherr; diameter " +
                      (p.propellerDiameter_m ? "as entered" : "Kristensen & Luetzen 2013") +
                      "; telegraph steps, engine and its rates usual for the size, " +
                      (full_rpm < kDirectBelow_rpm ? "direct drive started by air" : "geared"));
}

Json steeringGroup(const Particulars& p, const Form& f, const Rudders& r) {
    Json rudders = Json::array();
    for (const double y_m : r.across_m)
        rudders.push_back({{"x_m", neat(-0.5 * f.length_m)}, {"y_m", neat(y_m)}});
    return marked(
        {{"rudders", rudders},
         {"areaEach_m2", neat(r.areaEach_m2)},
         {"liftSlope_perDeg", neat(r.liftSlope_perRad * kDegree_rad)},
         {"stallAngle_deg", 35.0},
         {"limit_deg", 35.0},
         {"rate_degps", neat(std::clamp(240.0 / f.length_m, 2.4, 7.0))},
         {"lag_s", 0.5},
         {"raceShare", neat(r.raceShare)}},
        std::string(p.rudderArea_m2 ? "area as entered"
                                    : "area by the DNV rule T L / 100 (1 + 25 (B/L)^2), more where usual for "
                                      "the type (Molland & Turnock 2007)") +
            "; lift slope Fujii for an aspect ratio of 1.8, with the wake and the hull's share (Kijima 1990) "
            "taken in; race by the MMG model at the service speed (Yasukawa & Yoshimura 2015), 0.7 of it, "
            "for "
            "a rudder hard over is partly out of it; rate of SOLAS II-1/29 and above");
}

/// A tunnel as deep as it goes, loaded as makers load them: 320 kW per square metre.
Json thrusterGroup(double power_W, const Form& f) {
    constexpr double kLoading_Wpm2 = 320e3;
    const double diameter_m =
        std::clamp(std::sqrt(4.0 / kPi * power_W / kLoading_Wpm2), 0.15, 0.6 * f.draught_m);
    Json units = Json::array();
    units.push_back({{"id", "bow"},
                     {"x_m", neat(0.41 * f.length_m)},
                     {"y_m", 0.0},
                     {"height_m", neat(-std::max(0.55 * f.draught_m, f.draught_m - 1.2 * diameter_m))},
                     {"diameter_m", neat(diameter_m)},
                     {"power_kW", neat(1e-3 * power_W)},
                     {"rampTime_s", 5.0}});
    return marked({{"units", units}},
                  "power as entered; thrust Beveridge 1972; tunnel of 320 kW per square metre, as low as it "
                  "goes, 0.41 Lpp forward; ramp usual of electric drives");
}

/// Fast for her weight: speed over sqrt(g V^(1/3)).
bool planes(const Form& f, const Drive& d) {
    constexpr double kPlanesFrom = 2.0;
    return d.speed_mps > kPlanesFrom * std::sqrt(kGravity_mps2 * std::cbrt(f.volume_m3));
}

Json planingGroup(const Form& f, const Drive& d) {
    return marked({{"chineBeam_m", neat(0.85 * f.beam_m)},
                   {"deadrise_deg", 18.0},
                   {"gravityFromTransom_m", neat(0.5 * f.length_m + buoyancyForward_m(f, d.speed_mps))}},
                  "a craft of volume Froude number above 2 planes; chines and deadrise usual of such, centre "
                  "of gravity over the centre of buoyancy afloat");
}

struct Windage {
    double frontal_m2, lateral_m2, forward_m, height_m;
};
Windage windageOf(const ShipKind& kind, const Form& f) {
    const double side_m2 = 0.97 * f.lengthOverall_m * f.freeboard_m,
                 house_m2 = kind.superstructure * f.lengthOverall_m * f.houseHeight_m;
    const double half = 0.5 * kind.superstructure;
    const double middle = std::clamp(kind.bridge - half, -0.5 + half, 0.5 - half);
    Windage w{};
    w.frontal_m2 = f.beam_m * (f.freeboard_m + 0.85 * f.houseHeight_m);
    w.lateral_m2 = side_m2 + house_m2;
    w.forward_m = middle * f.lengthOverall_m * house_m2 / w.lateral_m2;
    w.height_m =
        (0.5 * f.freeboard_m * side_m2 + (f.freeboard_m + 0.5 * f.houseHeight_m) * house_m2) / w.lateral_m2;
    return w;
}

}  // namespace

double neat(double value) {
    if (value == 0.0) return 0.0;
    const double scale = std::pow(10.0, 3.0 - std::floor(std::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}

Json documentOf(const Particulars& p, const ShipKind& kind, const Form& f, const Drive& drive) {
    const std::vector<double> shafts_m = shaftsAcross_m(p.shafts, f.beam_m);
    const Rudders rudders = ruddersOf(p, kind, f, drive, shafts_m);
    const Windage wind = windageOf(kind, f);
    const double number = equipmentNumber(f, wind.lateral_m2);
    Json document{{"document", "vessel"}, {"version", 1}, {"id", p.id}, {"name", p.name}, {"type", p.kind}};
    document["bridgeEye"] = {{"x_m", neat(kind.bridge * f.lengthOverall_m)},
                             {"y_m", 0.0},
                             {"height_m", neat(std::clamp(f.freeboard_m + f.houseHeight_m, 1.5, 60.0))}};
    document["hull"] = hullGroup(p, f);
    if (planes(f, drive)) document["planing"] = planingGroup(f, drive);
    document["model"] = modelGroup(f, drive, rudders, p.shafts);
    const double froude = drive.speed_mps / std::sqrt(kGravity_mps2 * f.length_m);
    document["seakeeping"] = marked({{"heaveAddedMassRatio", 1.0},
                                     {"heaveDampingRatio", 0.3},
                                     {"pitchAddedInertiaRatio", 1.0},
                                     {"pitchDampingRatio", 0.3},
                                     {"rollAddedInertiaRatio", 0.2},
                                     {"rollDampingRatio", neat(0.05 + 0.2 * froude)}},
                                    "ratios usual for displacement hulls (Journee & Massie 2001, chapter 8); "
                                    "roll damping with the lift damping of the service speed");
    document["propulsion"] = propulsionGroup(p, f, drive, shafts_m);
    document["steering"] = steeringGroup(p, f, rudders);
    if (p.bowThruster_W) document["thrusters"] = thrusterGroup(*p.bowThruster_W, f);
    document["windage"] = marked({{"blendermannType", kind.blendermannType},
                                  {"frontalArea_m2", neat(wind.frontal_m2)},
                                  {"lateralArea_m2", neat(wind.lateral_m2)},
                                  {"centroidForward_m", neat(wind.forward_m)},
                                  {"centroidHeight_m", neat(wind.height_m)}},
                                 "coefficients: Blendermann 1994; areas of the hull above water and of a "
                                 "superstructure usual for the type and size");
    document["shallowWater"] = marked(
        {{"squat", "barrass"}, {"hull", "kijima"}, {"bank", "norrbin"}, {"ships", "slender-body"}},
        "squat: Barrass 1979; hull: Kijima & Nakiri 1990; banks: Norrbin 1974; ships: Tuck & Newman 1974");
    document["mooring"] = mooringGroup(f, number);
    document["groundTackle"] = groundTackleGroup(f, number);
    return document;
}

}  // namespace sagara::core::estimate
