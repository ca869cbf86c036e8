#include "core/motion/ShipInteraction.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

constexpr int kStrips = 12, kSources = 8;
/// Of the momentum the cross flow takes from the forebody the afterbody gives back so much: a hull that
/// drifts then has 1.3 times its sway added mass as Yv' and 0.6 times as Nv', as measured ones have
/// (KVLCC2: 1.4, 0.6).
constexpr double kRecovered = 0.15;

/// Area of a section, 1.5 vol/L (1 - (2x/L)^2), and its slope.
struct Section {
    double area_m2, slope_m;
};
Section sectionAt(const SlenderShip& ship, double x_m) {
    const double middle_m2 = 1.5 * ship.displacement_m3 / ship.length_m, s = 2.0 * x_m / ship.length_m;
    return {middle_m2 * (1.0 - s * s), -4.0 * middle_m2 * s / ship.length_m};
}

/// Of a source in the free surface between it and the ground: velocity = q/(4 pi) r K(r), r horizontal.
/// K = sum over all images of (r^2 + (2 n h)^2)^-3/2, those beyond the first as an integral; slope = K'/r.
struct Kernel {
    double K, slope;
};
Kernel kernel(double r2, double depth_m) {
    Kernel k{0.0, 0.0};
    const auto add = [&](double z2, double weight) {
        const double s2 = 1.0 / (r2 + z2), s3 = s2 * std::sqrt(s2);
        k.K += weight * s3;
        k.slope -= weight * 3.0 * s3 * s2;
    };
    add(0.0, 1.0);
    const double twoDepths_m = 2.0 * depth_m;
    if (twoDepths_m * twoDepths_m > 100.0 * r2) return k;
    add(twoDepths_m * twoDepths_m, 2.0);
    const double z = 1.5 * twoDepths_m, s = std::sqrt(r2 + z * z), tail = 1.0 - z / s;
    k.K += 2.0 / twoDepths_m * tail / r2;
    k.slope += 2.0 / twoDepths_m * (z / (s * s * s * r2) - 2.0 * tail / (r2 * r2));
    return k;
}

/// Stream of the other ship and its rate of change at a point that moves with own, both in own's frame.
struct Stream {
    BodyPoint velocity, rate;
    double sideGradient_perS;  ///< of its side component along own's centreline
};
Stream streamAt(const SlenderShip& other, BodyPoint place, BodyPoint along, BodyPoint relative_mps,
                double x_m, double depth_m, double least2_m2) {
    Stream stream{};
    const double step_m = other.length_m / kSources;
    // So few sources, strengthened to have the first moment of the whole line.
    constexpr double kWhole = kSources * kSources / (kSources * kSources - 1.0);
    for (int j = 0; j < kSources; ++j) {
        const double at_m = (j + 0.5) * step_m - 0.5 * other.length_m;
        const double rx = x_m - place.x_m - at_m * along.x_m, ry = -place.y_m - at_m * along.y_m;
        const Kernel k = kernel(std::max(rx * rx + ry * ry, least2_m2), depth_m);
        // the double body has twice the area below the surface
        const double q =
            -2.0 * kWhole * other.surge_mps * sectionAt(other, at_m).slope_m * step_m / (4.0 * kPi);
        const double towards = k.slope * (rx * relative_mps.x_m + ry * relative_mps.y_m);
        stream.velocity.x_m += q * rx * k.K;
        stream.velocity.y_m += q * ry * k.K;
        stream.sideGradient_perS += q * ry * rx * k.slope;
        stream.rate.x_m += q * (relative_mps.x_m * k.K + rx * towards);
        stream.rate.y_m += q * (relative_mps.y_m * k.K + ry * towards);
    }
    return stream;
}

}  // namespace

Load interactionLoad(const SlenderShip& own, const SlenderShip& other, double depth_m,
                     double waterDensity_kgpm3) {
    const double apart = distance(own.position, other.position) / (own.length_m + other.length_m);
    constexpr double kTooSmall = 1e-3;
    if (apart >= 2.0 || other.surge_mps == 0.0 || other.displacement_m3 < kTooSmall * own.displacement_m3)
        return {};
    const HeadingFrame frame(own.position, own.heading_rad);
    const BodyPoint place = frame.vectorInBody(other.position - own.position);
    const BodyPoint along = frame.vectorInBody(unitVector(other.heading_rad));
    const BodyPoint theirs_mps{other.surge_mps * along.x_m - other.sway_mps * along.y_m,
                               other.surge_mps * along.y_m + other.sway_mps * along.x_m};
    const BodyPoint relative_mps{own.surge_mps - theirs_mps.x_m, own.sway_mps - theirs_mps.y_m};
    const double least_m = 0.4 * (own.beam_m + other.beam_m);

    Load load;
    const double step_m = own.length_m / kStrips, U = own.surge_mps;
    for (int i = 0; i < kStrips; ++i) {
        const double x = (i + 0.5) * step_m - 0.5 * own.length_m;
        const Stream s = streamAt(other, place, along, relative_mps, x, depth_m, least_m * least_m);
        const Section section = sectionAt(own, x);
        const double u = s.velocity.x_m, v = s.velocity.y_m;
        load.surge_N += section.area_m2 * s.rate.x_m + U * section.slope_m * u;
        const double recovered = x > 0.0 ? 1.0 : kRecovered;
        const double side = 2.0 * section.area_m2 * s.rate.y_m -
                            U * recovered * (section.slope_m * v + section.area_m2 * s.sideGradient_perS) -
                            U * section.area_m2 * s.sideGradient_perS;
        load.sway_N += side;
        load.yaw_Nm += x * side;
    }
    const double fade = std::clamp(2.0 * (2.0 - apart), 0.0, 1.0);
    return fade * waterDensity_kgpm3 * step_m * load;
}

}  // namespace sagara::core
