#include "core/motion/MmgHullForce.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/motion/CrossFlow.h"
#include "core/motion/SmoothStep.h"

namespace sagara::core {
namespace {

constexpr double kSlowest_mps = 1e-6;
constexpr double kFadeOver_rad = 25.0 * kDegree_rad;  ///< of drift, beyond the published range
constexpr double kFadeToYawRate = 2.0;                ///< times the published range

/// X, Y, N over their pressure scales.
struct Coefficients {
    double X, Y, N;
};

Coefficients polynomial(const MmgHull& k, double v, double r, double phi) {
    return {.X = -k.R0 + k.Xvv * v * v + k.Xvr * v * r + k.Xrr * r * r + k.Xvvvv * v * v * v * v +
                 k.Xrphi * r * phi,
            .Y = k.Yv * v + k.Yr * r + k.Yvvv * v * v * v + k.Yvvr * v * v * r + k.Yvrr * v * r * r +
                 k.Yrrr * r * r * r + k.Yvv * v * std::abs(v) + k.Yrr * r * std::abs(r) +
                 (k.Yphi + k.Yvvphi * v * v + k.Yvrphi * v * r + k.Yrrphi * r * r) * phi,
            .N = k.Nv * v + k.Nr * r + k.Nvvv * v * v * v + k.Nvvr * v * v * r + k.Nvrr * v * r * r +
                 k.Nrrr * r * r * r + k.Nvv * v * std::abs(v) + k.Nrr * r * std::abs(r) +
                 (k.Nphi + k.Nvvphi * v * v + k.Nvrphi * v * r + k.Nrrphi * r * r) * phi};
}

Load unified(const MmgParameters& model, const Hull& hull, const ShipMotion& m, const MmgFlow& flow) {
    const MmgHull& k = model.hull;
    const double L = hull.lengthBp_m, scale = 0.5 * hull.waterDensity_kgpm3 * L * hull.draught_m;
    const double u = m.surge_mps, v = m.sway_mps, rL = m.yawRate_radps * L;
    const double turned = std::abs(flow.drift_rad) / kPi;  // 0 ahead, 1 astern
    const double resistance = k.R0 * (1.0 + (model.range.asternResistance - 1.0) * turned);
    const double drag = model.range.crossFlowDrag;
    Load f;
    f.sway_N = crossFlowDrag(hull, drag, v, model.range.crossFlowSwayLever * m.yawRate_radps).sway_N;
    f.yaw_Nm = crossFlowDrag(hull, drag, v, model.range.crossFlowYawLever * m.yawRate_radps).yaw_Nm;
    f.surge_N += scale * (-resistance * u * flow.speed_mps + k.Xvr * v * rL);
    f.sway_N += scale * (k.Yv * std::abs(u) * v + k.Yr * u * rL);
    f.yaw_Nm += scale * L * (k.Nv * u * v + k.Nr * std::abs(u) * rL);
    return f;
}

}  // namespace

MmgFlow mmgFlow(const MmgRange& range, double length_m, const ShipMotion& m) {
    MmgFlow f;
    const double u = m.surge_mps, v = m.sway_mps;
    f.speed_mps = std::sqrt(u * u + v * v);
    const double divisor_mps = std::max(kSlowest_mps, f.speed_mps);
    f.drift_rad = u == 0.0 && v == 0.0 ? 0.0 : std::atan2(-v, u);
    f.v = v / divisor_mps;
    f.r = m.yawRate_radps * length_m / divisor_mps;
    f.published =
        range.drift_rad <= 0.0 || range.yawRate <= 0.0
            ? 0.0
            : (1.0 - smoothStep(range.drift_rad, range.drift_rad + kFadeOver_rad, std::abs(f.drift_rad))) *
                  (1.0 - smoothStep(range.yawRate, kFadeToYawRate * range.yawRate, std::abs(f.r)));
    return f;
}

Load mmgHullForce(const MmgParameters& model, const Hull& hull, const ShipMotion& m, const MmgFlow& flow) {
    Load published;
    if (flow.published > 0.0) {
        const Coefficients c = polynomial(model.hull, flow.v, flow.r, m.roll_rad);
        const double scale_N = 0.5 * hull.waterDensity_kgpm3 * hull.lengthBp_m * hull.draught_m *
                               flow.speed_mps * flow.speed_mps;
        published.surge_N = scale_N * c.X;
        published.sway_N = scale_N * c.Y;
        published.yaw_Nm = scale_N * hull.lengthBp_m * c.N;
        if (flow.published == 1.0) return published;
    }
    return flow.published * published + (1.0 - flow.published) * unified(model, hull, m, flow);
}

}  // namespace sagara::core
