#include "core/seakeeping/MeanWaveForce.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/seakeeping/Hydrostatics.h"

namespace sagara::core {
namespace {

using Complex = std::complex<double>;

/// Of waves of this number a wall of the draught reflects this share, pi^2 I1^2 / (pi^2 I1^2 + K1^2).
double stoppedShare(double waveNumber_radpm, double draught_m) {
    const double kd = std::min(waveNumber_radpm * draught_m, 20.0);
    if (kd < 1e-6) return 0.0;
    const double i = kPi * std::cyl_bessel_i(1.0, kd), k = std::cyl_bessel_k(1.0, kd);
    return i * i / (i * i + k * k);
}

/// A piece of the waterline: forward along the starboard side, aft along the other.
struct Side {
    double x_m, y_m;  ///< its middle
    double dx_m, dy_m;
};

/// How much of the wave's momentum a piece of the waterline takes, over density.
void reflect(const Side& side, const MetWave& wave, MeanWaveForce& sum) {
    const double length_m = std::hypot(side.dx_m, side.dy_m);
    if (length_m <= 0.0) return;
    const double along = std::cos(wave.relativeHeading_rad), across = -std::sin(wave.relativeHeading_rad);
    const double tx = side.dx_m / length_m, ty = side.dy_m / length_m;
    const double inX = ty, inY = -tx;  // into the hull
    const double facing = along * inX + across * inY;
    if (facing <= 0.0) return;
    const double ahead = along < 0.0 ? 2.0 * wave.omega_radps * wave.speed_mps / kGravity_mps2 *
                                           (1.0 + tx * (tx * along + ty * across))
                                     : 0.0;
    const double force = 0.5 * kGravity_mps2 * (facing * facing + ahead) * length_m;
    sum.surge_Npm2 += force * inX;
    sum.sway_Npm2 += force * inY;
    sum.yaw_NmPm2 += force * (side.x_m * inY - side.y_m * inX);
}

MeanWaveForce reflected(const StripHull& hull, const MetWave& wave) {
    MeanWaveForce sum;
    for (std::size_t i = 0; i + 1 < hull.strips.size(); ++i) {
        const Strip &a = hull.strips[i], &b = hull.strips[i + 1];
        const double x_m = 0.5 * (a.x_m + b.x_m), y_m = 0.25 * (a.breadth_m + b.breadth_m);
        const double dx_m = b.x_m - a.x_m, dy_m = 0.5 * (b.breadth_m - a.breadth_m);
        reflect({x_m, y_m, dx_m, dy_m}, wave, sum);
        reflect({x_m, -y_m, -dx_m, dy_m}, wave, sum);
    }
    const Strip &aft = hull.strips.front(), &fore = hull.strips.back();
    reflect({aft.x_m, 0.0, 0.0, aft.breadth_m}, wave, sum);
    reflect({fore.x_m, 0.0, 0.0, -fore.breadth_m}, wave, sum);
    return sum;
}

/// Damping of the heaving sections, less what the stream takes along, over density.
std::vector<double> heaveDamping(const StripHull& hull, const HullFlow& flow, double speed_mps) {
    std::vector<double> added, damping;
    for (std::size_t i = 0; i < hull.strips.size(); ++i) {
        const SectionRadiation r = radiationOf(hull.strips[i].panels, flow.strips[i]);
        added.push_back(r.addedMass.heave_m2);
        damping.push_back(flow.omega_radps * r.dampingOverOmega.heave_m2);
    }
    for (std::size_t i = 0; i < added.size(); ++i) {
        const std::size_t low = i > 0 ? i - 1 : i, high = std::min(i + 1, added.size() - 1);
        damping[i] -= speed_mps * (added[high] - added[low]) / (hull.x_m[high] - hull.x_m[low]);
    }
    return damping;
}

}  // namespace

MeanWaveForce meanWaveForce(const StripHull& hull, const HullFlow& flow, const MetWave& wave,
                            const Complex6& motion) {
    const double k = wave.waveNumber_radpm(), along = std::cos(wave.relativeHeading_rad),
                 across = -std::sin(wave.relativeHeading_rad);
    const double sense = wave.encounter_radps() < 0.0 ? -1.0 : 1.0;
    const std::vector<double> damping = heaveDamping(hull, flow, wave.speed_mps);
    std::vector<double> force(damping.size()), moment(damping.size());
    for (std::size_t i = 0; i < damping.size(); ++i) {
        const double x_m = hull.x_m[i], breadth_m = hull.strips[i].breadth_m;
        const double depth_m = breadth_m > 0.0 ? hull.strips[i].stated.area_m2 / breadth_m : 0.0;
        const Complex ship =
            Complex(0.0, flow.omega_radps) * (motion[2] - x_m * motion[4]) + wave.speed_mps * motion[4];
        const Complex water = Complex(0.0, -sense * wave.omega_radps) *
                              std::polar(std::exp(-k * depth_m), -sense * k * x_m * along);
        force[i] = damping[i] * std::norm(ship - water);
    }
    const double frequency = std::max(wave.encounter_radps(), wave.omega_radps);
    const double unit = 0.5 * k / frequency;
    const double radiated = std::max(0.0, unit * alongStations(hull.x_m, force, 0));
    const double turning = unit * alongStations(hull.x_m, force, 1);
    MeanWaveForce sum = reflected(hull, wave);
    double draught_m = 0.0;
    for (const Strip& s : hull.strips)
        if (s.breadth_m > 0.0) draught_m = std::max(draught_m, s.stated.area_m2 / s.breadth_m);
    const double share = stoppedShare(k, draught_m);
    const double density = hull.waterDensity_kgpm3;
    return {density * (share * sum.surge_Npm2 + along * radiated),
            density * (share * sum.sway_Npm2 + across * radiated),
            density * (share * sum.yaw_NmPm2 + across * turning)};
}

}  // namespace sagara::core
