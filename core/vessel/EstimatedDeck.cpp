#include <algorithm>
#include <cmath>

#include "core/base/Config.h"
#include "core/base/Units.h"
#include "core/vessel/EstimatedGroups.h"

namespace sagara::core::estimate {

using Json = nlohmann::ordered_json;

double equipmentNumber(const Form& f, double lateralArea_m2) {
    return std::pow(f.mass_kg() / kTonne_kg, 2.0 / 3.0) +
           2.0 * (f.freeboard_m + 0.8 * f.houseHeight_m) * f.beam_m + 0.1 * lateralArea_m2;
}

Json mooringGroup(const Form& f, double number) {
    Json fairleads = Json::array();
    const auto pair = [&](const char* place, double alongShare, double acrossShare) {
        for (const double side : {-1.0, 1.0}) {
            fairleads.push_back({{"id", std::string(place) + (side < 0.0 ? "-port" : "-starboard")},
                                 {"x_m", neat(alongShare * f.lengthOverall_m)},
                                 {"y_m", neat(side * acrossShare * f.beam_m)}});
        }
    };
    pair("bow", 0.46, 0.18);
    pair("forward", 0.28, 0.45);
    pair("aft", -0.30, 0.48);
    pair("stern", -0.48, 0.40);
    const double breaking_kN = std::clamp(60.0 + 0.3 * number, 40.0, 1800.0);
    constexpr double kStretchAtBreak = 0.17;
    return {
        {"fairleads", fairleads},
        {"breakingLoad_kN", neat(breaking_kN)},
        {"stiffness_kN", neat(breaking_kN / kStretchAtBreak)},
        {"winchPull_kN", neat(std::clamp(0.25 * breaking_kN, 5.0, 400.0))},
        {"winchSpeed_mps", 0.25},
        {"source",
         "breaking load follows the equipment number (IACS Rec. 10), each line standing for two; polyester, "
         "17 % stretch at break; fairleads where they usually are"},
        {"quality", "estimated"}};
}

Json groundTackleGroup(const Form& f, double number) {
    const double anchor_kg = std::clamp(3.0 * number, 20.0, 40000.0);
    const double cable_mm = std::max(11.0, 1.6 * std::sqrt(number));
    const double cable_m = 0.5 * 247.5 * std::pow(number / 100.0, 0.30);
    Json anchors = Json::array();
    for (const double side : {-1.0, 1.0}) {
        anchors.push_back(
            {{"id", side < 0.0 ? "port" : "starboard"},
             {"x_m", neat(0.43 * f.lengthOverall_m)},
             {"y_m", neat(side * 0.16 * f.beam_m)},
             {"hawseHeight_m", neat(std::clamp(0.85 * f.freeboard_m + 0.3, 0.3, 30.0))},
             {"anchorMass_kg", neat(anchor_kg)},
             {"holdingFactor", anchor_kg > 2000.0 ? 4.5 : 7.0},
             {"cable_shackles", std::clamp(std::round(cable_m / kShackle_m), 3.0, 14.0)},
             {"cableMass_kgpm", neat(0.0219 * cable_mm * cable_mm)},
             {"breakingLoad_kN", neat(0.01373 * cable_mm * cable_mm * (44.0 - 0.08 * cable_mm))},
             {"heaveSpeed_mps", 0.15}});
    }
    return {{"anchors", anchors},
            {"source",
             "equipment number " + config::formatNumber(std::round(number)) +
                 " (IACS UR A1): two stockless bowers of 3 kg and grade 2 stud-link cable of 1.6 mm by the "
                 "square root of it; cable mass and breaking load UR W18"},
            {"quality", "estimated"}};
}

}  // namespace sagara::core::estimate
