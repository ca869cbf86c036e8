#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/Problems.h"
#include "core/base/Result.h"

namespace sagara::core {

/// What is usual for a kind of ship, where a builder's list says nothing.
struct ShipKind {
    const char* name;  ///< also the "type" of the document
    const char* blendermannType;
    double draughtOverDepth;
    double bridge;            ///< front of the wheelhouse from midship, forward, over length overall
    double superstructure;    ///< its length over length overall
    double gravityOverDepth;  ///< KG over depth
    double leastWaterplane;   ///< waterplane coefficient of transom forms
    double rudderShare;       ///< of length by draught, where usual ships have more than the DNV rule
    double skegShare;         ///< of it too: skeg, deadwood, brackets aft; 0 where they are little
    bool fullForm;            ///< propeller diameter as of tankers and bulk carriers
    bool bulb;                ///< at 90 m and more
};
inline constexpr std::array<ShipKind, 15> kShipKinds{{
    {"tanker", "tanker loaded", 0.76, -0.37, 0.12, 0.56, 0.0, 0.0, 0.0, true, true},
    {"bulk carrier", "cargo vessel loaded", 0.72, -0.38, 0.12, 0.58, 0.0, 0.0, 0.0, true, true},
    {"general cargo", "cargo vessel loaded", 0.72, -0.36, 0.18, 0.60, 0.0, 0.02, 0.0, false, true},
    {"container ship", "container ship loaded", 0.60, -0.22, 0.75, 0.62, 0.70, 0.0, 0.0, false, true},
    {"gas carrier", "LNG tanker", 0.48, -0.36, 0.50, 0.58, 0.0, 0.0, 0.0, false, true},
    {"car carrier", "car carrier", 0.32, 0.40, 0.85, 0.55, 0.72, 0.018, 0.0, false, true},
    {"ferry", "ferry", 0.42, 0.36, 0.75, 0.62, 0.74, 0.021, 0.0, false, true},
    {"passenger ship", "passenger liner", 0.38, 0.36, 0.80, 0.62, 0.74, 0.018, 0.0, false, true},
    {"fishing vessel", "fishing vessel", 0.72, 0.06, 0.40, 0.70, 0.76, 0.032, 0.06, false, false},
    {"offshore supply vessel", "offshore supply vessel", 0.75, 0.28, 0.32, 0.66, 0.80, 0.025, 0.03, false,
     false},
    {"tug", "tender", 0.72, 0.12, 0.50, 0.66, 0.80, 0.04, 0.12, false, false},
    {"patrol vessel", "destroyer", 0.45, 0.15, 0.55, 0.65, 0.74, 0.027, 0.015, false, false},
    {"fast craft", "speed boat", 0.42, 0.05, 0.60, 0.62, 0.76, 0.035, 0.05, false, false},
    {"yacht", "speed boat", 0.52, 0.05, 0.60, 0.60, 0.74, 0.032, 0.03, false, false},
    {"research vessel", "research vessel", 0.65, 0.16, 0.50, 0.64, 0.72, 0.022, 0.0, false, false},
}};
/// The kind of that name, or null.
const ShipKind* findShipKind(std::string_view name);

/// The main particulars of a ship as a shipyard's list gives them.
struct Particulars {
    std::string id;
    std::string name;
    std::string kind = kShipKinds[0].name;
    double lengthOverall_m = 0.0;
    double lengthBp_m = 0.0;
    double beam_m = 0.0;
    double draught_m = 0.0;
    std::optional<double> depth_m;          ///< keel to main deck; none: usual for the kind
    std::optional<double> displacement_m3;  ///< one of these two
    std::optional<double> blockCoefficient;
    std::optional<double> metacentricHeight_m;  ///< GM; none: by form and usual centre of gravity
    double speed_mps = 0.0;                     ///< service speed, made at 85 % of the power
    std::optional<double> power_W;  ///< of all engines, maximum continuous; none: what her resistance takes
    int shafts = 1;
    int rudders = 1;
    std::optional<double> rudderArea_m2;  ///< of all rudders, what moves; none: usual for the kind
    std::optional<double> propellerDiameter_m;
    std::optional<double> bowThruster_W;  ///< none: she has none
    std::string source;                   ///< of these numbers; empty: entered by hand

    double volume_m3() const {
        return displacement_m3 ? *displacement_m3
                               : blockCoefficient.value_or(0.0) * lengthBp_m * beam_m * draught_m;
    }
};

/// The power that vesselFromParticulars takes for a ship of which none is given: what the resistance of
/// Holtrop and Mennen takes at the service speed. For particulars it accepts.
double powerForResistance_W(const Particulars& particulars);

/// A complete vessel document (JSON), every group of it estimated by published regressions and marked so with
/// its source. The ship makes her speed at full ahead, steers, stops, backs and lies to her lines; accuracy
/// of such estimates is some 20 to 30 % in turning. Problems name the member of `Particulars`.
Result<std::string, config::Problems> vesselFromParticulars(const Particulars& particulars);

}  // namespace sagara::core
