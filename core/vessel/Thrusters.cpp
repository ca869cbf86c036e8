#include "core/vessel/Thrusters.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/vessel/ReadPoint.h"

namespace sagara::core {
namespace {

constexpr std::size_t kMostUnits = 4;
constexpr double kSeaWater_kgpm3 = 1025.0;

Thruster readUnit(const config::Node& node) {
    config::Reader in(node);
    Thruster t;
    t.id = in.id("id");
    t.position = readBodyPoint(in);
    t.height_m = in.number("height_m", {-30.0, 0.0, "m"});
    t.diameter_m = in.number("diameter_m", {0.1, 5.0, "m"});
    if (in.has("thrust_kN")) {
        t.thrust_N = 1e3 * in.number("thrust_kN", {0.1, 1000.0, "kN"});
    } else {
        t.thrust_N =
            tunnelThrust_N(1e3 * in.number("power_kW", {1.0, 6000.0, "kW"}), t.diameter_m, kSeaWater_kgpm3);
    }
    t.rampTime_s = in.number("rampTime_s", {0.1, 60.0, "s"});
    in.rejectUnknownKeys();
    return t;
}

}  // namespace

double tunnelThrust_N(double power_W, double diameter_m, double density_kgpm3) {
    constexpr double kMerit = 0.95;
    const double area_m2 = kPi / 4.0 * diameter_m * diameter_m;
    return kMerit * std::cbrt(density_kgpm3 * area_m2 * power_W * power_W);
}

Thrusters readThrusters(config::Reader& in) {
    Thrusters t;
    for (const config::Node& node : in.list("units")) {
        Thruster unit = readUnit(node);
        const auto same = [&](const Thruster& other) { return other.id == unit.id; };
        if (std::any_of(t.units.begin(), t.units.end(), same))
            node.problem("has the id \"" + unit.id + "\" again", "each id once");
        t.units.push_back(std::move(unit));
    }
    if (in.has("units") && (t.units.empty() || t.units.size() > kMostUnits))
        in.problem("units", "has " + std::to_string(t.units.size()) + " units", "1 to 4");
    t.provenance = readProvenance(in);
    in.rejectUnknownKeys();
    return t;
}

}  // namespace sagara::core
