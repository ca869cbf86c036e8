#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/vessel/Estimate.h"
#include "core/vessel/Metacentre.h"

namespace sagara::core::estimate {

Form formOf(const Particulars& p, const ShipKind& kind) {
    Form f{};
    f.length_m = p.lengthBp_m;
    f.lengthOverall_m = p.lengthOverall_m;
    f.beam_m = p.beam_m;
    f.draught_m = p.draught_m;
    f.volume_m3 = p.volume_m3();
    f.block = f.volume_m3 / (f.length_m * f.beam_m * f.draught_m);
    f.depth_m = p.depth_m.value_or(f.draught_m / kind.draughtOverDepth);
    f.freeboard_m = f.depth_m - f.draught_m;
    f.waterplane = std::clamp((1.0 + 2.0 * f.block) / 3.0, kind.leastWaterplane, 0.98);
    constexpr double kDeckHeight_m = 2.7;
    f.houseHeight_m = kDeckHeight_m * std::clamp(1.0 + f.lengthOverall_m / 62.0, 1.0, 7.0);

    f.skeg_m2 = kind.skegShare * f.length_m * f.draught_m;

    const double KM_m = metacentre_m(f.beam_m, f.draught_m, f.block, f.waterplane);
    const double GM_m = KM_m - kind.gravityOverDepth * f.depth_m;
    // Ships are loaded to sail between these; small craft are stiffer.
    const double most = std::clamp(0.20 - 0.07 * (f.length_m - 25.0) / 75.0, 0.13, 0.20);
    f.metacentric_m = p.metacentricHeight_m.value_or(
        std::clamp(GM_m, std::max(0.3, 0.03 * f.beam_m), std::max(0.5, most * f.beam_m)));
    f.gravityHeight_m = KM_m - f.metacentric_m;
    const double C = std::clamp(0.373 + 0.023 * f.beam_m / f.draught_m - 0.043 * f.length_m / 100.0, 0.35,
                                0.45);  // period = 2 C B / sqrt(GM)
    const double virtual_m = C * f.beam_m * std::sqrt(kGravity_mps2) / kPi;
    f.rollGyradius_m = virtual_m / std::sqrt(1.2);
    return f;
}

double buoyancyForward_m(const Form& f, double speed_mps) {
    const double froude = speed_mps / std::sqrt(kGravity_mps2 * f.length_m);
    return f.length_m * std::clamp(0.0970 - 0.45 * froude, -0.035, 0.035);
}

double frictionalResistance_N(const Form& form, double speed_mps) {
    const double logRe = std::log10(std::max(1e5, speed_mps * form.length_m / kViscosity_m2ps));
    const double coefficient = 0.075 / ((logRe - 2.0) * (logRe - 2.0));
    const double wetted_m2 = 1.7 * form.length_m * form.draught_m + form.volume_m3 / form.draught_m;
    return 0.5 * kWater_kgpm3 * wetted_m2 * coefficient * speed_mps * speed_mps;
}

Derivatives derivativesOf(const Form& f) {
    const double L = f.length_m, B = f.beam_m, T = f.draught_m, Cb = f.block;
    const double half = 0.5 * kWater_kgpm3, k = kPi * (T / L) * (T / L);
    // Some of the regressions change sign for very short, beamy hulls, where a yaw damping cannot.
    const auto positive = [](double value, double least) { return std::max(value, least); };
    Derivatives d{};
    d.Xudot = -2.7 * kWater_kgpm3 * std::pow(f.volume_m3, 5.0 / 3.0) / (L * L);
    d.Yvdot = -k * positive(1.0 + 0.16 * Cb * B / T - 5.1 * (B / L) * (B / L), 0.3) * half * L * L * L;
    d.Nrdot = -k * positive(1.0 / 12.0 + 0.017 * Cb * B / T - 0.33 * B / L, 0.03) * half * std::pow(L, 5);
    d.Yv = -k * (1.0 + 0.40 * Cb * B / T) * half * L * L;
    d.Yr = -k * (-0.5 + 2.2 * B / L - 0.080 * B / T) * half * L * L * L;
    d.Nv = -k * (0.5 + 2.4 * T / L) * half * L * L * L;
    d.Nr = -k * positive(0.25 + 0.039 * B / T - 0.56 * B / L, 0.08) * half * std::pow(L, 4);
    d.crossFlowDrag = std::clamp(2.5 * T * (1.0 - Cb) / B + 0.5, 0.4, 1.2);
    return d;
}

}  // namespace sagara::core::estimate
