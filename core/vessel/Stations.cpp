#include "core/vessel/Stations.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace sagara::core {
namespace {

constexpr std::size_t kFewest = 5, kMost = 400;

}  // namespace

std::vector<HullStation> readStations(config::Reader& in, double length_m, double beam_m) {
    std::vector<HullStation> stations;
    if (!in.has("stations")) return stations;
    const std::vector<config::Node> rows = in.list("stations");
    if (rows.size() < kFewest || rows.size() > kMost) {
        in.problem("stations", "has " + std::to_string(rows.size()) + " rows",
                   std::to_string(kFewest) + " to " + std::to_string(kMost));
    }
    const auto number = [](double v) { return config::formatNumber(v); };
    double widest_m = 0.0;
    for (const config::Node& row : rows) {
        const std::vector<double> v = row.numbers(5, {-1e4, 1e4, "m or m2"});
        if (v.empty()) continue;
        const HullStation s{v[0], v[1], v[2], v[3], v[4]};
        const auto wrong = [&](const char* what, double found, const std::string& expected) {
            row.problem(std::string("has ") + what + " " + number(found), expected);
        };
        if (std::abs(s.x_m) > 0.5 * length_m + 0.01 * length_m)
            wrong("x_m", s.x_m,
                  "at most half of lengthOverall_m from midship, " + number(0.5 * length_m) + " m");
        if (!stations.empty() && s.x_m <= stations.back().x_m)
            wrong("x_m", s.x_m, "more than the row before, " + number(stations.back().x_m) + " m");
        if (s.breadth_m < 0.0) wrong("breadth_m", s.breadth_m, "0 m or more");
        if (s.draught_m < 0.0 || s.draught_m > 40.0) wrong("draught_m", s.draught_m, "0 to 40 m");
        if (s.area_m2 < 0.0 || s.area_m2 > 1.05 * beam_m * s.draught_m + 1e-6)
            wrong("area_m2", s.area_m2, "at most beam by draught, " + number(beam_m * s.draught_m) + " m2");
        widest_m = std::max(widest_m, s.breadth_m);
        stations.push_back(s);
    }
    if (!stations.empty() && in.sound() && std::abs(widest_m - beam_m) > 0.03 * beam_m) {
        in.problem("stations", "have a greatest breadth of " + number(widest_m) + " m",
                   "beam_m, " + number(beam_m) + " m, to 3 %");
    }
    return stations;
}

}  // namespace sagara::core
