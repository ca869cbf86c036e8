#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Units.h"
#include "core/seakeeping/StripTheory.h"

namespace sagara::core {
namespace {

using Complex = std::complex<double>;
constexpr Complex kI(0.0, 1.0);

/// What a wave does to a strip, its phase taken at the strip's centreline. x forward, y to port, z up.
struct StripForce {
    Complex surge;
    Complex sway;
    Complex heave;
    Complex roll;

    StripForce& operator+=(const StripForce& o) {
        surge += o.surge;
        sway += o.sway;
        heave += o.heave;
        roll += o.roll;
        return *this;
    }
};
StripForce operator*(Complex s, const StripForce& f) {
    return {s * f.surge, s * f.sway, s * f.heave, s * f.roll};
}

/// The wave over one strip: wave number, and its parts along and across the hull.
struct Cut {
    double k;
    double along;   ///< cosine of the relative heading
    double across;  ///< sine
};

Cut cutOf(const MetWave& wave) {
    return {wave.waveNumber_radpm(), std::cos(wave.relativeHeading_rad), std::sin(wave.relativeHeading_rad)};
}

/// Pressure of the undisturbed wave. What the station has more than its panels is added as in a long wave, so
/// that the force is that of the hydrostatics there.
StripForce froudeKrylov(const Strip& strip, const Cut& wave, double weight) {
    StripForce f;
    for (const SectionPanel& p : strip.panels) {
        const double decay = 2.0 * p.length_m * std::exp(wave.k * p.middle.z_m);
        const double phase = wave.k * wave.across * p.middle.y_m;
        f.sway += kI * (decay * p.normalY * std::sin(phase));
        f.heave -= decay * p.normalZ * std::cos(phase);
        f.roll += kI * (decay * p.normalRoll_m() * std::sin(phase));
    }
    const double half_m = strip.panels.back().to.z_m > -1e-9 ? strip.panels.back().to.y_m : 0.0;
    const double phase = wave.k * wave.across * half_m;
    const double waterplane_m = 2.0 * half_m * (std::abs(phase) > 1e-6 ? std::sin(phase) / phase : 1.0);
    const double water_m = waterplane_m - f.heave.real();  // k times the area, weighed by the pressure
    const double decay = std::exp(-wave.k * strip.stated.depth_m);
    const double more_m2 = (strip.stated.area_m2 - strip.fitted.area_m2) * decay;
    const double moreMoment_m3 =
        (strip.stated.area_m2 * strip.stated.depth_m - strip.fitted.area_m2 * strip.fitted.depth_m) * decay;
    f.surge = kI * wave.along * (water_m + wave.k * more_m2);
    f.sway += kI * wave.k * wave.across * more_m2;
    f.roll += kI * wave.k * wave.across * moreMoment_m3;
    f.heave += strip.breadth_m - 2.0 * half_m - wave.k * more_m2;
    return weight * f;
}

/// By the radiation potentials, per unit of the product of both frequencies and of density.
StripForce diffraction(const Strip& strip, const SectionFlow& flow, const Cut& wave) {
    StripForce f;
    for (std::size_t i = 0; i < strip.panels.size(); ++i) {
        const SectionPanel& p = strip.panels[i];
        const double decay = 2.0 * p.length_m * std::exp(wave.k * p.middle.z_m);
        const double phase = wave.k * wave.across * p.middle.y_m;
        const double c = decay * std::cos(phase), s = decay * std::sin(phase);
        const double even = p.normalZ * c - wave.across * p.normalY * s;
        const Complex odd = -kI * (p.normalZ * s + wave.across * p.normalY * c);
        f.heave += even * flow.heave_m[i];
        f.sway += odd * flow.sway_m[i];
        f.roll += odd * flow.roll_m2[i];
    }
    return f;
}

/// Where forces of strips go: surge acts at the depth of the centre of buoyancy; `shift` is U / (i w) in the
/// terms of forward speed.
std::array<Complex, 6> weighed(const StripForce& f, double x_m, double depth_m, Complex shift) {
    return {f.surge,
            f.sway,
            f.heave,
            f.roll,
            -(x_m + shift) * f.heave - depth_m * f.surge,
            (x_m + shift) * f.sway};
}

/// Along the hull: the strips' amplitudes change by straight lines, the wave's phase as it does.
std::array<Complex, 6> integrated(const StripHull& hull, const std::vector<StripForce>& strips,
                                  const std::vector<double>& depth_m, const Cut& wave, Complex shift) {
    std::array<Complex, 6> sum{};
    for (std::size_t i = 1; i < strips.size(); ++i) {
        const double dx_m = hull.x_m[i] - hull.x_m[i - 1];
        const int steps = 2 + static_cast<int>(std::min(wave.k * std::abs(wave.along) * dx_m / 0.3, 40.0));
        for (int n = 0; n < steps; ++n) {
            const double share = (n + 0.5) / steps, x_m = hull.x_m[i - 1] + share * dx_m;
            StripForce f = (1.0 - share) * strips[i - 1];
            f += share * strips[i];
            const double phase = wave.k * wave.along * x_m;
            const Complex turn = (dx_m / steps) * Complex(std::cos(phase), -std::sin(phase));
            const auto all = weighed(f, x_m, (1.0 - share) * depth_m[i - 1] + share * depth_m[i], shift);
            for (std::size_t j = 0; j < 6; ++j) sum[j] += turn * all[j];
        }
    }
    return sum;
}

/// From z up to frame B.
Complex6 toFrameB(const std::array<Complex, 6>& f) {
    Complex6 force;
    for (std::size_t j = 0; j < 6; ++j) force.set(j, j == 0 || j == 3 ? f[j] : -f[j]);
    return force;
}

/// The potentials of a negative frequency are the conjugates of those of the positive one.
SectionFlow conjugate(SectionFlow flow) {
    for (auto* list : {&flow.sway_m, &flow.heave_m, &flow.roll_m2})
        for (Complex& value : *list) value = std::conj(value);
    return flow;
}

std::vector<double> depths(const StripHull& hull) {
    std::vector<double> list;
    for (const Strip& s : hull.strips) list.push_back(s.stated.depth_m);
    return list;
}

}  // namespace

Complex6 froudeKrylovForce(const StripHull& hull, const MetWave& wave) {
    const Cut cut = cutOf(wave);
    std::vector<StripForce> strips;
    for (const Strip& s : hull.strips)
        strips.push_back(s.panels.empty() ? StripForce{}
                                          : froudeKrylov(s, cut, hull.waterDensity_kgpm3 * kGravity_mps2));
    return toFrameB(integrated(hull, strips, depths(hull), cut, 0.0));
}

Complex6 diffractionForce(const StripHull& hull, const HullFlow& flow, const MetWave& wave,
                          bool transomTerms) {
    const Cut cut = cutOf(wave);
    const double encounter_radps = wave.encounter_radps();
    const double factor = hull.waterDensity_kgpm3 * wave.omega_radps * encounter_radps;
    std::vector<StripForce> strips;
    for (std::size_t i = 0; i < hull.strips.size(); ++i) {
        const SectionFlow& section = flow.strips[i];
        const StripForce f = encounter_radps < 0.0 ? diffraction(hull.strips[i], conjugate(section), cut)
                                                   : diffraction(hull.strips[i], section, cut);
        strips.push_back(factor * f);
    }
    const Complex shift =
        std::abs(encounter_radps) > 1e-9 ? wave.speed_mps / (kI * encounter_radps) : Complex(0.0, 0.0);
    std::array<Complex, 6> sum = integrated(hull, strips, depths(hull), cut, shift);
    if (transomTerms) {
        const double x_m = hull.x_m.front();
        const auto end = weighed(strips.front(), x_m, 0.0, 0.0);
        const Complex turn = shift * std::exp(-kI * (cut.k * cut.along * x_m));
        for (std::size_t j = 0; j < 6; ++j) sum[j] += turn * end[j];
    }
    // The water the hull carries in surge, by the mean acceleration along it.
    const Complex6 pressure = froudeKrylovForce(hull, wave);
    const Complex surge = pressure[0] *
                          (hull.surgeAddedMass_kg / (hull.waterDensity_kgpm3 * hull.volume_m3)) *
                          (encounter_radps / wave.omega_radps);
    sum[0] += surge;
    sum[4] -= hull.buoyancyDepth_m * surge;
    return toFrameB(sum);
}

}  // namespace sagara::core
