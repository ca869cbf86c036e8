#include "core/sea/Beaufort.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "core/base/Angle.h"

namespace sagara::core {
namespace {

struct Row {
    std::string_view name;
    double windMin_mps;
    double oceanHs_m, oceanT1_s;
    double inshoreHs_m, inshoreT1_s;
};

// Wind limits: WMO. Heights and periods: Journee and Massie, Offshore Hydromechanics (2001), recalled, 10 %.
constexpr std::array<Row, kBeaufortMax + 1> kScale{{
    {"calm", 0.0, 0.0, 0.0, 0.0, 0.0},
    {"light air", 0.3, 1.1, 5.8, 0.5, 3.5},
    {"light breeze", 1.6, 1.2, 5.9, 0.65, 3.8},
    {"gentle breeze", 3.4, 1.4, 6.0, 0.8, 4.2},
    {"moderate breeze", 5.5, 1.7, 6.1, 1.1, 4.6},
    {"fresh breeze", 8.0, 2.15, 6.5, 1.65, 5.1},
    {"strong breeze", 10.8, 2.9, 7.2, 2.5, 5.7},
    {"near gale", 13.9, 3.75, 7.8, 3.6, 6.7},
    {"gale", 17.2, 4.9, 8.4, 4.85, 7.9},
    {"strong gale", 20.8, 6.1, 9.0, 6.1, 8.8},
    {"storm", 24.5, 7.45, 9.6, 7.45, 9.5},
    {"violent storm", 28.5, 8.7, 10.1, 8.7, 10.0},
    {"hurricane", 32.7, 10.25, 10.5, 10.25, 10.5},
}};

const Row& row(int number) {
    assert(number >= 0 && number <= kBeaufortMax);
    return kScale[static_cast<std::size_t>(number)];
}

double mix(double a, double b, double fraction) { return a + (b - a) * fraction; }

}  // namespace

int beaufortOfWind(double speed_mps) {
    int number = 0;
    while (number < kBeaufortMax && speed_mps >= row(number + 1).windMin_mps) ++number;
    return number;
}

std::string_view beaufortName(int number) { return row(number).name; }

double windOfBeaufort_mps(int number) {
    if (number == 0) return 0.0;
    if (number == kBeaufortMax) return row(number).windMin_mps;
    return 0.5 * (row(number).windMin_mps + row(number + 1).windMin_mps);
}

std::optional<WaveSystem> windSea(double speed_mps, double windFrom_rad, Exposure exposure) {
    if (beaufortOfWind(speed_mps) == 0) return std::nullopt;
    int low = 0;  // the band whose middle is the last one not above the wind
    while (low < kBeaufortMax - 1 && speed_mps >= windOfBeaufort_mps(low + 1)) ++low;
    const double from_mps = windOfBeaufort_mps(low), to_mps = windOfBeaufort_mps(low + 1);
    const double fraction = std::min((speed_mps - from_mps) / (to_mps - from_mps), 1.0);
    const Row &a = row(low), &b = row(low + 1);
    const bool ocean = exposure == Exposure::Ocean;
    const double meanPeriod_s =
        low == 0 ? (ocean ? b.oceanT1_s : b.inshoreT1_s)
                 : mix(ocean ? a.oceanT1_s : a.inshoreT1_s, ocean ? b.oceanT1_s : b.inshoreT1_s, fraction);
    WaveSystem sea;
    sea.significantHeight_m =
        mix(ocean ? a.oceanHs_m : a.inshoreHs_m, ocean ? b.oceanHs_m : b.inshoreHs_m, fraction);
    sea.gamma = ocean ? 1.0 : 3.3;
    sea.peakPeriod_s = meanPeriod_s * peakOverMeanPeriod(sea.gamma);
    sea.wavesTo_rad = wrapTwoPi(windFrom_rad + kPi);
    sea.spreading = 4.0;
    return sea;
}

}  // namespace sagara::core
