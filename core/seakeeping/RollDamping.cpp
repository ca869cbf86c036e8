#include "core/seakeeping/RollDamping.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

// Coefficients of the regression, highest power first; named as the authors name them.
constexpr std::array<double, 4> kA111{-0.002222, 0.040871, -0.286866, 0.599424};
constexpr std::array<double, 4> kA112{0.010185, -0.161176, 0.904989, -1.641389};
constexpr std::array<double, 4> kA113{-0.015422, 0.220371, -1.084987, 1.834167};
constexpr std::array<double, 5> kA121{-0.0628667, 0.4989259, 0.52735, -10.7918672, 16.616327};
constexpr std::array<double, 5> kA122{0.1140667, -0.8108963, -2.2186833, 25.1269741, -37.7729778};
constexpr std::array<double, 5> kA123{-0.0589333, 0.2639704, 3.1949667, -21.8126569, 31.4113508};
constexpr std::array<double, 5> kA124{0.0107667, 0.0018704, -1.2494083, 6.9427931, -10.2018992};
constexpr std::array<double, 4> kA131{0.192207, -2.787462, 12.507855, -14.764856};
constexpr std::array<double, 4> kA132{-0.350563, 5.222348, -23.974852, 29.007851};
constexpr std::array<double, 4> kA133{0.237096, -3.535062, 16.368376, -20.539908};
constexpr std::array<double, 4> kA134{-0.067119, 0.966362, -4.407535, 5.894703};
constexpr std::array<double, 4> kAA111{17.945, -166.294, 489.799, -493.142};
constexpr std::array<double, 4> kAA112{-25.507, 236.275, -698.683, 701.494};
constexpr std::array<double, 4> kAA113{9.077, -84.332, 249.983, -250.787};
constexpr std::array<double, 4> kAA121{-16.872, 156.399, -460.689, 463.848};
constexpr std::array<double, 4> kAA122{24.015, -222.507, 658.027, -660.665};
constexpr std::array<double, 4> kAA123{-8.56, 79.549, -235.827, 236.579};
constexpr std::array<double, 4> kA2{-1.402, 7.189, -10.993, 9.45};
constexpr std::array<double, 7> kA31{-7686.0287, 30131.5678, -49048.9664, 42480.7709,
                                     -20665.147, 5355.2035,  -577.8827};
constexpr std::array<double, 7> kA32{61639.9103,  -241201.0598, 392579.5937, -340629.4699,
                                     166348.6917, -43358.7938,  4714.7918};
constexpr std::array<double, 7> kA33{-130677.4903, 507996.2604, -826728.7127, 722677.104,
                                     -358360.7392, 95501.4948,  -10682.8619};
constexpr std::array<double, 7> kA34{-110034.6584, 446051.22,  -724186.4643, 599411.9264,
                                     -264294.7189, 58039.7328, -4774.6414};
constexpr std::array<double, 7> kA35{709672.0656, -2803850.2395, 4553780.5017, -3888378.9905,
                                     1839829.259, -457313.6939,  46600.823};
constexpr std::array<double, 7> kA36{-822735.9289,  3238899.7308, -5256636.5472, 4500543.147,
                                     -2143487.3508, 538548.1194,  -55751.1528};
constexpr std::array<double, 7> kA37{299122.8727, -1175773.1606, 1907356.1357, -1634256.8172,
                                     780020.9393, -196679.7143,  20467.0904};
constexpr std::array<double, 4> kAA311Slope{-17.102, 41.495, -33.234, 8.8007};
constexpr std::array<double, 4> kAA311Constant{36.566, -89.203, 71.8, -18.108};
constexpr std::array<double, 4> kAA31{-0.3767, 3.39, -10.356, 11.588};
constexpr std::array<double, 3> kAA32{-0.0727, 0.7, -1.2818};
constexpr std::array<double, 9> kAA3{-1.05584,  12.688,     -63.70534, 172.84571, -274.05701,
                                     257.68705, -141.40915, 44.13177,  -7.1654};
constexpr std::array<double, 3> kAA3Constant{-0.0495, 0.4518, -0.61655};
constexpr std::array<double, 4> kBE2{-219.2, 443.7, -283.3, 59.6};
constexpr std::array<double, 5> kFE2{-79.414, 215.695, -215.883, 93.894, -14.848};

template <std::size_t N>
double at(const std::array<double, N>& coefficients, double x) {
    double sum = 0.0;
    for (const double c : coefficients) sum = sum * x + c;
    return sum;
}

double wavePart(double CB, double CM, double BD, double x4, double frequency) {
    const double A11 = (at(kA111, BD) * CB + at(kA112, BD)) * CB + at(kA113, BD);
    const double A12 = ((at(kA121, BD) * CB + at(kA122, BD)) * CB + at(kA123, BD)) * CB + at(kA124, BD);
    const double A13 = ((at(kA131, BD) * CB + at(kA132, BD)) * CB + at(kA133, BD)) * CB + at(kA134, BD);
    const double AA11 = (at(kAA111, BD) * CB + at(kAA112, BD)) * CB + at(kAA113, BD);
    const double AA12 = (at(kAA121, BD) * CB + at(kAA122, BD)) * CB + at(kAA123, BD);
    const double AA1 = (AA11 * CM + AA12) * (1.0 - x4) + 1.0;
    const double A1 = ((A11 * x4 + A12) * x4 + A13) * AA1;
    const std::array<double, 7> A3i{at(kA31, CB), at(kA32, CB), at(kA33, CB), at(kA34, CB),
                                    at(kA35, CB), at(kA36, CB), at(kA37, CB)};
    const double xx4 = x4 - at(kAA32, BD);
    const double AA311 = at(kAA311Slope, CB) * x4 + at(kAA311Constant, CB);
    const double AA3 = at(kAA31, BD) * AA311 * (xx4 * at(kAA3, xx4) + at(kAA3Constant, BD));
    const double A3 = at(A3i, x4) + AA3;
    return A1 / frequency * std::exp(-at(kA2, x4) * std::pow(std::log(frequency) - A3, 2) / 1.44);
}

double frictionPart(const IkedaShip& s, double amplitude_rad, double omega_radps, double viscosity_m2ps) {
    const double BD = s.breadth_m / s.draught_m, CB = s.blockCoefficient;
    const double radius_m =
        s.draught_m * ((0.887 + 0.145 * CB) * (1.7 + CB * BD) - 2.0 * s.gravityBelowWater_m / s.draught_m) /
        kPi;
    const double surface_m2 = s.lengthBp_m * (1.75 * s.draught_m + CB * s.breadth_m);
    const double period_s = kTwoPi / omega_radps;
    const double Cf =
        1.328 / std::sqrt(3.22 * std::pow(radius_m * amplitude_rad, 2) / (period_s * viscosity_m2ps));
    const double perDensity =
        4.0 / (3.0 * kPi) * surface_m2 * std::pow(radius_m, 3) * amplitude_rad * omega_radps * Cf;
    const double volume_m3 = s.lengthBp_m * s.breadth_m * s.draught_m * CB;
    return perDensity / (volume_m3 * s.breadth_m * s.breadth_m) *
           std::sqrt(s.breadth_m / (2.0 * kGravity_mps2));
}

double eddyPart(const IkedaShip& s, double amplitude_rad, double frequency) {
    const double BD = s.breadth_m / s.draught_m, CB = s.blockCoefficient,
                 OGd = s.gravityBelowWater_m / s.draught_m;
    const double AE = (-0.0182 * CB + 0.0155) * std::pow(BD - 1.8, 3) + at(kFE2, CB);
    const double BE1 = (3.98 * CB - 5.1525) * (-0.2 * BD + 1.6) * OGd *
                       ((0.9717 * CB * CB - 1.55 * CB + 0.723) * OGd + 0.04567 * CB + 0.9408);
    const double BE2 = (0.25 * OGd + 0.95) * OGd + at(kBE2, CB);
    const double BE3 = -15.0 * CB * BD + 46.5 * CB + 11.2 * BD - 28.6;
    return 4.0 * frequency * amplitude_rad / (3.0 * kPi * CB * std::pow(BD, 3)) * AE *
           std::exp(BE1 + BE2 * std::pow(s.midshipCoefficient, BE3));
}

double bilgeKeelPart(const IkedaShip& s, double amplitude_rad, double frequency) {
    const double b = s.bilgeKeelBreadth_m / s.breadth_m, l = s.bilgeKeelLength_m / s.lengthBp_m;
    if (b <= 0.0 || l <= 0.0) return 0.0;
    const double BD = s.breadth_m / s.draught_m, CB = s.blockCoefficient,
                 OGd = s.gravityBelowWater_m / s.draught_m;
    const double phi = amplitude_rad / kDegree_rad;
    const double f1 = (-0.3651 * CB + 0.3907) * std::pow(BD - 2.83, 2) - 2.21 * CB + 2.632;
    const double f2 = 0.00255 * phi * phi + 0.122 * phi + 0.4794;
    const double f3 = (-0.8913 * b * b - 0.0733 * b) * l * l + (5.2857 * b * b - 0.01185 * b + 0.00189) * l;
    const double B1 = (5.0 * b + 0.3 * BD - 0.2 * l + 0.00125 * phi * phi - 0.0425 * phi - 1.86) * OGd;
    const double B2 = -15.0 * b + 1.2 * CB - 0.1 * BD - 0.0657 * OGd * OGd + 0.0586 * OGd + 1.6164;
    const double B3 = 2.5 * OGd + 15.75;
    return f1 * f2 * f3 * std::exp(B1 + B2 * std::pow(s.midshipCoefficient, B3)) * frequency;
}

/// N m s; Ikeda, Himeno and Tanaka (1978): the hull as a lifting surface that rolls while it goes ahead.
double liftDamping_Nms(const IkedaShip& s, double waterDensity_kgpm3, double speed_mps) {
    const double L = s.lengthBp_m, d = s.draught_m, OG = s.gravityBelowWater_m, CM = s.midshipCoefficient;
    const double kappa = CM <= 0.92 ? 0.0 : CM <= 0.97 ? 0.1 : 0.3;
    const double slope = kTwoPi * d / L + kappa * (4.1 * s.breadth_m / L - 0.045);
    const double l0 = 0.3 * d, lR = 0.5 * d;
    return 0.5 * waterDensity_kgpm3 * speed_mps * L * d * slope * l0 * lR *
           (1.0 - 1.4 * OG / lR + 0.7 * OG * OG / (l0 * lR));
}

}  // namespace

IkedaDamping ikedaDamping(const IkedaShip& s, double amplitude_rad, double omega_radps,
                          double viscosity_m2ps) {
    const double frequency = omega_radps * std::sqrt(s.breadth_m / (2.0 * kGravity_mps2));
    return {frictionPart(s, amplitude_rad, omega_radps, viscosity_m2ps),
            wavePart(s.blockCoefficient, s.midshipCoefficient, s.breadth_m / s.draught_m,
                     1.0 - s.gravityBelowWater_m / s.draught_m, frequency),
            eddyPart(s, amplitude_rad, frequency), bilgeKeelPart(s, amplitude_rad, frequency)};
}

IkedaShip inRange(IkedaShip s) {
    s.blockCoefficient = std::clamp(s.blockCoefficient, 0.5, 0.85);
    s.midshipCoefficient = std::clamp(s.midshipCoefficient, 0.9, 0.99);
    s.draught_m = std::clamp(s.draught_m, s.breadth_m / 4.5, s.breadth_m / 2.5);
    s.gravityBelowWater_m = std::clamp(s.gravityBelowWater_m, -1.5 * s.draught_m, 0.2 * s.draught_m);
    s.bilgeKeelLength_m = std::min(s.bilgeKeelLength_m, 0.4 * s.lengthBp_m);
    s.bilgeKeelBreadth_m = std::min(s.bilgeKeelBreadth_m, 0.06 * s.breadth_m);
    return s;
}

double viscousRollDamping_Nms(const IkedaShip& ship, double waterDensity_kgpm3, double volume_m3,
                              double amplitude_rad, double omega_radps, double speed_mps) {
    const IkedaShip s = inRange(ship);
    const double omega = std::clamp(omega_radps, 1e-3, std::sqrt(2.0 * kGravity_mps2 / s.breadth_m));
    const IkedaDamping at =
        ikedaDamping(s, std::clamp(amplitude_rad, 0.5 * kDegree_rad, 30.0 * kDegree_rad), omega);
    const double travel = omega * s.lengthBp_m;
    const double washed = std::pow(0.04 * travel, 2);
    const double share = washed / (washed + speed_mps * speed_mps);
    const double unit = waterDensity_kgpm3 * volume_m3 * s.breadth_m * s.breadth_m /
                        std::sqrt(s.breadth_m / (2.0 * kGravity_mps2));
    return unit * (std::max(at.friction, 0.0) * (1.0 + 4.1 * speed_mps / travel) +
                   std::max(at.eddy, 0.0) * share + std::max(at.bilgeKeel, 0.0)) +
           liftDamping_Nms(ship, waterDensity_kgpm3, speed_mps);
}

}  // namespace sagara::core
