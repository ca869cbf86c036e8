#include "core/vessel/OpenWater.h"

#include <algorithm>

namespace sagara::core {
namespace {

double valueAt(const std::vector<double>& polynomial, double J) {
    double value = 0.0;
    for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) value = *c + J * value;
    return value;
}

std::vector<OpenWater::Row> readTable(config::Reader& unit) {
    std::vector<OpenWater::Row> table;
    for (const config::Node& node : unit.list("openWater")) {
        const std::vector<double> row = node.numbers(3, {-2.0, 2.5, ""});
        if (row.empty()) continue;
        if (!table.empty() && row[0] <= table.back().J)
            node.problem("has J " + config::formatNumber(row[0]),
                         "more than in the row before, " + config::formatNumber(table.back().J));
        table.push_back({row[0], {row[1], row[2]}});
    }
    if (unit.has("openWater") && (table.size() < 3 || table.front().J != 0.0))
        unit.problem("openWater", "has " + std::to_string(table.size()) + " rows",
                     "three or more rows [J, KT, KQ], the first at J = 0");
    return table;
}

}  // namespace

OpenWaterPoint OpenWater::at(double J) const {
    if (table.empty()) return {valueAt(thrust, J), valueAt(torque, J)};
    std::size_t i = 1;
    while (i + 1 < table.size() && table[i].J < J) ++i;
    const Row &a = table[i - 1], &b = table[i];
    const double s = std::clamp((J - a.J) / (b.J - a.J), 0.0, 1.0);
    return {a.at.thrust + s * (b.at.thrust - a.at.thrust), a.at.torque + s * (b.at.torque - a.at.torque)};
}

double OpenWater::highestJ() const {
    if (!table.empty()) return table.back().J;
    constexpr double kStep = 0.005, kMost = 2.5;
    double J = kStep;
    while (J < kMost && valueAt(thrust, J) > 0.0) J += kStep;
    return J;
}

OpenWater readOpenWater(config::Reader& unit, std::vector<double> thrust) {
    OpenWater w;
    config::Reader screw(unit.child("wageningenB"));
    w.screw.blades = screw.integer("blades", 2, 7);
    w.screw.areaRatio = screw.number("areaRatio", {0.30, 1.05, ""});
    w.screw.pitchRatio = screw.number("pitchRatio", {0.5, 1.4, ""});
    screw.rejectUnknownKeys();
    const auto ofSeries = [](const std::array<double, 4>& c) {
        return std::vector<double>(c.begin(), c.end());
    };
    w.thrust = thrust.empty() ? ofSeries(w.screw.thrustPolynomial()) : std::move(thrust);
    w.torque = unit.has("torqueCoefficients") ? unit.numbers("torqueCoefficients", 0, {-1.0, 1.0, ""})
                                              : ofSeries(w.screw.torquePolynomial());
    if (unit.has("openWater")) w.table = readTable(unit);
    return w;
}

}  // namespace sagara::core
