#include "core/motion/MmgShallow.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {

ShallowFactors shallowFactors(const Hull& hull, double depth_m) {
    constexpr double kLeastRatio = 1.1;
    ShallowFactors f;
    if (std::isinf(depth_m)) return f;
    const double L = hull.lengthBp_m, B = hull.beam_m, d = hull.draught_m, Cb = hull.blockCoefficient();
    const double H = std::max(kLeastRatio, depth_m / d), x = 1.0 / H, full = Cb * B / d;
    const auto kijima = [&](double n) { return std::pow(1.0 - x, -n) - x; };
    f.Yv = kijima(0.40 * full);
    f.Nv = kijima(0.425 * full);
    // Of hulls deeper than 0.105 L the regression for Nr knows nothing: it goes with Nv there.
    const double ofSwing = 1.5 - 7.14 * 2.0 * d / L;
    f.Nr = ofSwing > 0.0 ? kijima(ofSwing) : f.Nv;
    const double F = H - 1.0;
    const double K0 = 1.0 + (0.0775 + (-0.0110 + 0.000068 / (F * F)) / F) / (F * F);
    const double finite = 2.2 * B / L - 0.080 * B / d;
    f.Yr = (0.5 * K0 - finite) / (0.5 - finite);
    const double p13 = std::pow(F, 1.3), p082 = std::pow(F, 0.82);
    f.mx = (p13 + std::max(0.0, 3.77 + 1.14 * B / d - 0.233 * L / d - 3.43 * Cb)) / p13;
    f.my = (p082 + 0.413 + 0.032 * B / d + 0.0129 * B * B / (d * d)) / p082;
    f.Jz = (p082 + 0.413 + 0.0192 * B / d + 0.00554 * B * B / (d * d)) / p082;
    f.resistance = 1.0 + 0.388 * x * x;
    f.inflow = std::cos(1.4 * Cb * x);
    f.push = 1.0 / (1.0 - 0.2 * x + 0.7295 * x * x);
    f.straightening = 1.0 + x * (0.0161 + x * (4.4222 - 4.9825 * x));
    return f;
}

MmgParameters mmgInDepth(const MmgParameters& deep, const Hull& hull, double depth_m) {
    if (std::isinf(depth_m)) return deep;
    const ShallowFactors f = shallowFactors(hull, depth_m);
    MmgParameters p = deep;
    // Of short beamy hulls the regression would carry along several times their own mass.
    constexpr double kMostCarried = 0.5;
    const double mass = hull.displacement_m3 / (0.5 * hull.lengthBp_m * hull.lengthBp_m * hull.draught_m);
    p.inertia.mx = std::min(p.inertia.mx * f.mx, std::max(p.inertia.mx, kMostCarried * mass));
    p.inertia.my *= f.my;
    p.inertia.Jz *= f.Jz;
    MmgHull& k = p.hull;
    k.R0 *= f.resistance;
    k.Xvr *= f.my;  // it is a share of m_y
    k.Yv *= f.Yv;
    k.Nv *= f.Nv;
    k.Nr *= f.Nr;
    k.Nrr *= f.Nr;
    for (double* ofCrossFlow : {&k.Yvvv, &k.Yvvr, &k.Yvrr, &k.Yrrr, &k.Yvv, &k.Yrr, &k.Nvvv, &k.Nvvr, &k.Nvrr,
                                &k.Nrrr, &k.Nvv, &p.range.crossFlowDrag})
        *ofCrossFlow *= f.Yv;
    k.Yr *= f.Yr;
    p.wake.inflow *= f.inflow;
    p.wake.push *= f.push;
    p.rudder.gammaPort *= f.straightening;
    p.rudder.gammaStarboard *= f.straightening;
    return p;
}

}  // namespace sagara::core
