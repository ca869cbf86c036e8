#include "core/motion/FourQuadrantSeries.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

/// Of cos k beta and sin k beta: 100 CT* and -1000 CQ*.
struct Harmonic {
    double thrustCos, thrustSin, torqueCos, torqueSin;
};
using Series = std::array<Harmonic, 21>;

constexpr Series kArea40{{{2.6614, 0, -3.0164, 0},
                          {15.21, -45.208, -22.609, 62.798},
                          {0.58496, -0.25662, 2.8027, -3.557},
                          {0.124, -2.1958, -0.40627, 4.3225},
                          {0.58317, -0.68275, -1.3371, 0.7427},
                          {-1.4497, 6.8057, 0.0080854, -11.474},
                          {-0.23586, -0.013586, -0.30625, 0.56226},
                          {0.14112, 1.5949, 0.68395, -3.2668},
                          {-0.25652, 0.2359, 0.08267, -0.034084},
                          {1.1617, -0.44863, -1.5681, 1.228},
                          {-0.069024, -0.20488, 0.58928, 0.31488},
                          {0.48012, 0.72939, -1.3963, -1.0651},
                          {0.12225, 0.11758, -0.063161, 0.32814},
                          {0.018858, 0.63909, -0.099631, -0.91986},
                          {0.041708, 0.094342, 0.061397, -0.18077},
                          {0.53829, -0.2558, -0.7453, 0.69849},
                          {0.067385, -0.20823, 0.44171, 0.087367},
                          {0.48559, -0.12937, -0.8006, 0.062145},
                          {0.046868, -0.13876, 0.082415, 0.14682},
                          {0.038216, -0.067134, 0.079696, -0.22208},
                          {-0.029226, 0.028668, -0.021586, -0.27584}}};

constexpr Series kPitch05{{{5.0001, 0, -3.2792, 0},
                           {5.876, -80.271, -5.2552, 61.374},
                           {-2.2733, -1.2337, 2.6413, -1.1267},
                           {2.1575, 11.762, -3.4908, -9.8851},
                           {-0.56527, -1.1263, -0.19581, 1.1875},
                           {-3.9577, 3.9944, 3.1287, -4.0676},
                           {0.45509, 0.82148, -0.56581, -0.21526},
                           {3.2426, -0.40882, -2.0201, 2.0145},
                           {-0.4235, -0.57539, 0.44606, 0.45146},
                           {-2.0298, 1.7398, 0.3988, -1.8924},
                           {-0.0023261, 0.83612, 0.03552, -0.2137},
                           {1.6667, -0.079228, 0.37716, 0.26951},
                           {0.096252, -0.52069, -0.10241, -0.009078},
                           {-0.3764, 0.58585, -0.84055, -0.58152},
                           {-0.1371, 0.21697, 0.16432, 0.34793},
                           {0.62941, -0.034327, 0.31864, -0.097472},
                           {0.069047, -0.093112, -0.0053692, -0.35771},
                           {0.15705, 0.30087, -0.59511, 0.15756},
                           {0.13879, -0.068619, 0.12325, 0.14972},
                           {0.23373, -0.25555, -0.022804, -0.25339},
                           {0.053738, -0.092172, -0.14037, -0.037172}}};

constexpr Series kPitch08{{{2.8757, 0, -2.5783, 0},
                           {13.007, -77.762, -15.727, 93.08},
                           {0.62869, -1.3032, -0.6896, -0.20482},
                           {2.8104, 10.58, -5.4402, -13.786},
                           {-1.6832, -1.0413, 2.4674, 1.5588},
                           {-4.4894, 4.5769, 5.0717, -6.8953},
                           {0.37703, 1.4296, -1.1964, -0.19773},
                           {3.1647, -0.39612, -3.1161, 3.1295},
                           {-0.13492, -0.9917, 1.5838, -0.011366},
                           {-1.9905, 2.0759, 1.4925, -4.0967},
                           {0.17576, 0.90153, -0.90898, -0.3281},
                           {1.975, -0.029877, -1.2135, 0.79539},
                           {-0.11063, -0.56354, 0.50126, -0.26624},
                           {-0.069828, 0.94773, -1.4143, -1.4536},
                           {0.25665, 0.23681, -0.18873, 0.68666},
                           {0.80681, -0.53204, 0.15422, 0.45499},
                           {-0.18781, -0.071537, 0.17294, -0.84792},
                           {0.29821, 0.52768, -1.333, -0.15911},
                           {0.48643, 0.0174, -0.2262, 0.59733},
                           {0.33893, -0.68105, 0.14299, 0.25445},
                           {-0.26851, -0.204, -0.045335, -0.21991}}};

constexpr Series kPitch10{{{2.6617, 0, -2.2945, 0},
                           {17.802, -74.797, -26.989, 110.38},
                           {1.3828, -1.3632, -1.8758, -0.52852},
                           {2.7871, 10.246, -6.3552, -16.544},
                           {-1.624, -1.0865, 2.1668, 1.929},
                           {-5.3084, 4.7346, 7.653, -8.448},
                           {0.1918, 1.1355, -0.56516, -0.90714},
                           {3.8318, -0.9318, -6.2654, 3.1042},
                           {-0.22892, -0.72471, 1.9211, 0.68648},
                           {-1.8656, 2.3747, 3.3456, -4.5196},
                           {0.349, 0.86208, -1.2956, -1.0928},
                           {2.2321, 0.0070224, -3.1294, -0.044966},
                           {-0.35976, -0.36422, 1.2475, 0.72404},
                           {0.13606, 0.91758, -1.4351, -1.5284},
                           {0.47192, 0.089383, -0.83201, -0.23983},
                           {0.87235, -0.59364, 0.034868, 1.6074},
                           {-0.35748, -0.070954, 0.89981, -0.66184},
                           {0.35955, 0.48825, -1.4247, -1.2084},
                           {0.52896, -0.090587, -1.1064, 0.58384},
                           {0.21045, -0.81163, 0.27359, 1.3397},
                           {-0.27057, -0.056659, 0.6759, -0.29095}}};

constexpr Series kPitch14{{{1.8891, 0, -6.273, 0},
                           {28.033, -65.683, -59.067, 137.18},
                           {1.886, -0.23066, 3.4811, -0.060201},
                           {0.59973, 7.4446, -4.3989, -20.555},
                           {-1.0858, -1.2398, -0.4052, 3.3632},
                           {-6.4362, 4.7921, 11.843, -8.9586},
                           {-0.15631, 0.71695, 3.086, -2.6638},
                           {5.0311, 0.034276, -13.137, -0.9819},
                           {-0.063924, -0.29434, -1.4057, 2.2511},
                           {-2.0315, 2.0101, 5.6834, -0.87269},
                           {0.60866, 0.27097, 0.26129, -3.1696},
                           {1.8917, 0.1648, -4.5913, -3.3156},
                           {-0.41935, -0.17983, -0.58107, 2.1286},
                           {0.67181, 1.0989, -0.12353, -1.0776},
                           {0.6423, -0.16326, -1.6486, -1.3561},
                           {0.72715, -1.3135, -4.3524, 2.0842},
                           {-0.17483, -0.0030559, 0.95606, 2.0193},
                           {0.17548, 0.46619, 2.0063, 0.33011},
                           {0.3548, -0.39988, -0.67764, -1.0371},
                           {0.0797, -0.74616, -2.086, 1.3432},
                           {-0.099109, 0.018552, 0.10021, 1.2629}}};

constexpr Series kArea100{{{3.6313, 0, -5.4152, 0},
                           {21.42, -88.911, -33.975, 130.8},
                           {1.5928, -1.6965, 0.53548, 0.89413},
                           {1.8415, 14.273, -3.0096, -23.341},
                           {-2.8971, -1.8655, 3.9144, 4.0615},
                           {-5.6476, 2.6846, 6.1993, -3.6292},
                           {1.3012, 2.1062, -1.0195, -3.0396},
                           {3.2048, 1.128, -3.948, -0.21287},
                           {-0.722, -1.6558, 2.2104, 1.8664},
                           {-1.3587, 1.6606, 1.7921, -3.3024},
                           {0.30497, 1.2311, -0.89254, -2.5667},
                           {2.5154, 0.55586, -4.2271, -0.70419},
                           {-0.024965, -0.30974, -0.062203, 1.2292},
                           {-0.22675, 0.67583, -0.049032, -0.24159},
                           {0.71969, 0.31051, -0.63836, -0.00044045},
                           {1.2806, -0.70452, -1.0459, 1.0799},
                           {-0.63334, -0.24519, 1.2421, -0.2796},
                           {-0.18471, 0.59265, -0.34991, -0.93174},
                           {0.75799, 0.2908, -1.3759, -0.059079},
                           {0.71537, -0.73888, -0.66658, 1.5553},
                           {-0.48378, -0.24769, 1.1478, 0.2985}}};

constexpr std::size_t kSteps = 360;
using Table = std::array<StarCoefficients, kSteps>;

Table tableOf(const Series& series) {
    Table table{};
    for (std::size_t i = 0; i < kSteps; ++i) {
        const double beta_rad = kDegree_rad * static_cast<double>(i);
        for (std::size_t k = 0; k < series.size(); ++k) {
            const double c = std::cos(static_cast<double>(k) * beta_rad),
                         s = std::sin(static_cast<double>(k) * beta_rad);
            table[i].thrust += 0.01 * (series[k].thrustCos * c + series[k].thrustSin * s);
            table[i].torque -= 0.001 * (series[k].torqueCos * c + series[k].torqueSin * s);
        }
    }
    return table;
}

StarCoefficients between(const StarCoefficients& a, const StarCoefficients& b, double s) {
    return {a.thrust + s * (b.thrust - a.thrust), a.torque + s * (b.torque - a.torque)};
}

StarCoefficients read(const Table& table, double beta_rad) {
    const double turn = beta_rad / kDegree_rad, whole = std::floor(turn);
    const auto i = static_cast<std::size_t>(std::fmod(whole, 360.0) + (whole < 0.0 ? 360.0 : 0.0)) % kSteps;
    return between(table[i], table[(i + 1) % kSteps], turn - whole);
}

struct Tables {
    std::array<double, 4> pitches{0.5, 0.8, 1.0, 1.4};
    std::array<Table, 4> ofPitch{tableOf(kPitch05), tableOf(kPitch08), tableOf(kPitch10), tableOf(kPitch14)};
    Table narrow = tableOf(kArea40), wide = tableOf(kArea100);
};
const Tables& tables() {
    static const Tables made;
    return made;
}

/// Pitch within the series.
StarCoefficients ahead(double beta_rad, double pitchRatio, double areaRatio) {
    const Tables& t = tables();
    const double pitch = std::clamp(pitchRatio, t.pitches.front(), t.pitches.back());
    std::size_t i = 1;
    while (t.pitches[i] < pitch) ++i;
    StarCoefficients c = between(read(t.ofPitch[i - 1], beta_rad), read(t.ofPitch[i], beta_rad),
                                 (pitch - t.pitches[i - 1]) / (t.pitches[i] - t.pitches[i - 1]));
    const double area = (std::clamp(areaRatio, 0.40, 1.00) - 0.70) / 0.30;
    const StarCoefficients usual = read(t.ofPitch[2], beta_rad),
                           other = read(area < 0.0 ? t.narrow : t.wide, beta_rad);
    c.thrust += std::abs(area) * (other.thrust - usual.thrust);
    c.torque += std::abs(area) * (other.torque - usual.torque);
    return c;
}

StarCoefficients astern(double beta_rad, double pitchRatio, double areaRatio) {
    const StarCoefficients c = ahead(kPi - beta_rad, pitchRatio, areaRatio);
    return {c.thrust, -c.torque};
}

}  // namespace

StarCoefficients fourQuadrants(double beta_rad, double pitchRatio, double areaRatio) {
    constexpr double kLeast = 0.5;  // pitch of the series
    if (pitchRatio >= kLeast) return ahead(beta_rad, pitchRatio, areaRatio);
    if (pitchRatio <= -kLeast) return astern(beta_rad, -pitchRatio, areaRatio);
    // So mixed that blades without pitch push nothing at rest: hubs are set like that.
    const double back = astern(0.0, kLeast, areaRatio).thrust, forth = ahead(0.0, kLeast, areaRatio).thrust;
    const double even = -back / (forth - back), towards = pitchRatio / kLeast;
    return between(astern(beta_rad, kLeast, areaRatio), ahead(beta_rad, kLeast, areaRatio),
                   towards < 0.0 ? even * (1.0 + towards) : even + (1.0 - even) * towards);
}

}  // namespace sagara::core
