#include "core/vessel/Holtrop.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

double froudeOf(const HoltropHull& h, double speed_mps) {
    return speed_mps / std::sqrt(kGravity_mps2 * h.length_m);
}

/// Length of the run.
double runLength_m(const HoltropHull& h) {
    const double CP = h.prismatic();
    return h.length_m * (1.0 - CP + 0.06 * CP * h.buoyancy_pct / (4.0 * CP - 1.0));
}

/// Half angle of entrance of the waterline, degrees.
double entrance_deg(const HoltropHull& h) {
    const double L = h.length_m, slender = std::pow(L / h.beam_m, 0.80856);
    return 1.0 + 89.0 * std::exp(-slender * std::pow(1.0 - h.waterplane, 0.30484) *
                                 std::pow(1.0 - h.prismatic() - 0.0225 * h.buoyancy_pct, 0.6367) *
                                 std::pow(runLength_m(h) / h.beam_m, 0.34574) *
                                 std::pow(100.0 * h.volume_m3 / (L * L * L), 0.16302));
}

/// 1 + k1.
double formFactor(const HoltropHull& h) {
    const double L = h.length_m;
    return 0.93 + 0.487118 * (1.0 + 0.011 * h.sternForm) * std::pow(h.beam_m / L, 1.06806) *
                      std::pow(h.draught_m / L, 0.46106) * std::pow(L / runLength_m(h), 0.121563) *
                      std::pow(L * L * L / h.volume_m3, 0.36486) * std::pow(1.0 - h.prismatic(), -0.604247);
}

/// m4 cos(lambda / Fn^2): the hump and hollow of bow and stern waves.
double interference(const HoltropHull& h, double Fn) {
    const double L = h.length_m, CP = h.prismatic(), slender = L / h.beam_m;
    const double lambda = 1.446 * CP - (slender < 12.0 ? 0.03 * slender : 0.36);
    const double heavy = L * L * L / h.volume_m3;
    const double c15 = heavy < 512.0     ? -1.69385
                       : heavy > 1726.91 ? 0.0
                                         : -1.69385 + (L / std::cbrt(h.volume_m3) - 8.0) / 2.36;
    return 0.4 * c15 * std::exp(-0.034 * std::pow(Fn, -3.29)) * std::cos(lambda / (Fn * Fn));
}

/// c2: what a bulb leaves of the bow wave.
double bulbEffect(const HoltropHull& h) {
    const double c3 = 0.56 * std::pow(h.bulb_m2, 1.5) /
                      (h.beam_m * h.draught_m * (0.31 * std::sqrt(h.bulb_m2) + h.draught_m - h.bulbHeight_m));
    return std::exp(-1.89 * std::sqrt(c3));
}

/// Of a bulb near the surface.
double bulbResistance_N(const HoltropHull& h, double speed_mps, double weight_Npm3) {
    if (h.bulb_m2 <= 0.0) return 0.0;
    const double root_m = std::sqrt(h.bulb_m2);
    const double emergence = 0.56 * root_m / (h.draught_m - 1.5 * h.bulbHeight_m);
    const double immersion_m = h.draught_m - h.bulbHeight_m - 0.25 * root_m;
    const double Fn2 = speed_mps * speed_mps / (kGravity_mps2 * immersion_m + 0.15 * speed_mps * speed_mps);
    return 0.11 * std::exp(-3.0 / (emergence * emergence)) * std::pow(Fn2, 1.5) * std::pow(h.bulb_m2, 1.5) *
           weight_Npm3 / (1.0 + Fn2);
}

/// Of a transom that is not yet dry.
double transomResistance_N(const HoltropHull& h, double speed_mps, double pressure_Pa) {
    if (h.transom_m2 <= 0.0) return 0.0;
    const double Fn =
        speed_mps / std::sqrt(2.0 * kGravity_mps2 * h.transom_m2 / (h.beam_m * (1.0 + h.waterplane)));
    return pressure_Pa * h.transom_m2 * std::max(0.0, 0.2 * (1.0 - 0.2 * Fn));
}

/// Over the weight of the displaced water, for Froude numbers up to 0.4.
double slowWaves(const HoltropHull& h, double Fn) {
    const double L = h.length_m, B = h.beam_m, T = h.draught_m, CP = h.prismatic();
    const double c7 = B / L < 0.11   ? 0.229577 * std::cbrt(B / L)
                      : B / L > 0.25 ? 0.5 - 0.0625 * L / B
                                     : B / L;
    const double c1 = 2223105.0 * std::pow(c7, 3.78613) * std::pow(T / B, 1.07961) *
                      std::pow(90.0 - entrance_deg(h), -1.37565);
    const double c16 = CP < 0.8 ? ((6.984388 * CP - 13.8673) * CP + 8.07981) * CP : 1.73014 - 0.7067 * CP;
    const double m1 = 0.0140407 * L / T - 1.75254 * std::cbrt(h.volume_m3) / L - 4.79323 * B / L - c16;
    return c1 * std::exp(m1 * std::pow(Fn, -0.9) + interference(h, Fn));
}

/// The same from 0.55.
double fastWaves(const HoltropHull& h, double Fn) {
    const double L = h.length_m, B = h.beam_m;
    const double c17 = 6919.3 * std::pow(h.midship, -1.3346) * std::pow(h.volume_m3 / (L * L * L), 2.00977) *
                       std::pow(L / B - 2.0, 1.40692);
    const double m3 = -7.2035 * std::pow(B / L, 0.326869) * std::pow(h.draught_m / B, 0.605375);
    return c17 * std::exp(m3 * std::pow(Fn, -0.9) + interference(h, Fn));
}

double waves(const HoltropHull& h, double Fn) {
    constexpr double kSlow = 0.40, kFast = 0.55;
    if (Fn <= kSlow) return slowWaves(h, Fn);
    if (Fn >= kFast) return fastWaves(h, Fn);
    const double slow = slowWaves(h, kSlow);
    return slow + (10.0 * Fn - 4.0) / 1.5 * (fastWaves(h, kFast) - slow);
}

}  // namespace

HoltropResistance holtropResistance(const HoltropHull& h, double speed_mps, double density_kgpm3,
                                    double viscosity_m2ps) {
    const double L = h.length_m, B = h.beam_m, T = h.draught_m, CM = h.midship;
    const double CB = CM * h.prismatic();
    const double pressure_Pa = 0.5 * density_kgpm3 * speed_mps * speed_mps;
    const double logRe = std::log10(speed_mps * L / viscosity_m2ps);
    const double CF = 0.075 / ((logRe - 2.0) * (logRe - 2.0));
    HoltropResistance r;
    r.wetted_m2 = L * (2.0 * T + B) * std::sqrt(CM) *
                      (0.453 + 0.4425 * CB - 0.2862 * CM - 0.003467 * B / T + 0.3696 * h.waterplane) +
                  2.38 * h.bulb_m2 / CB;
    r.formFactor = formFactor(h);
    r.friction_N = pressure_Pa * CF * r.wetted_m2;
    r.appendages_N = pressure_Pa * CF * h.appendages_m2 * h.appendageForm;
    const double c2 = bulbEffect(h), c5 = 1.0 - 0.8 * h.transom_m2 / (B * T * CM);
    const double weight_Npm3 = density_kgpm3 * kGravity_mps2;
    r.waves_N = c2 * c5 * waves(h, froudeOf(h, speed_mps)) * h.volume_m3 * weight_Npm3;
    r.bulb_N = bulbResistance_N(h, speed_mps, weight_Npm3);
    r.transom_N = transomResistance_N(h, speed_mps, pressure_Pa);
    const double c4 = std::min(T / L, 0.04);
    const double CA = 0.006 * std::pow(L + 100.0, -0.16) - 0.00205 +
                      0.003 * std::sqrt(L / 7.5) * std::pow(CB, 4) * c2 * (0.04 - c4);
    r.allowance_N = pressure_Pa * (r.wetted_m2 + h.appendages_m2) * CA;
    return r;
}

bool holtropHolds(const HoltropHull& h, double speed_mps) {
    const double slender = h.length_m / h.beam_m, flat = h.beam_m / h.draught_m, CP = h.prismatic();
    return slender >= 3.9 && slender <= 15.0 && flat >= 2.1 && flat <= 4.0 && CP >= 0.55 && CP <= 0.85 &&
           froudeOf(h, speed_mps) <= 0.45;
}

}  // namespace sagara::core
