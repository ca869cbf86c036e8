#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/vessel/Estimate.h"

namespace sagara::core::estimate {
namespace {

MmgInertia inertiaOf(const Form& f, const Drive& drive, const Derivatives& d) {
    const double L = f.length_m, scale_kg = 0.5 * kWater_kgpm3 * L * L * f.draught_m;
    MmgInertia i;
    i.xG_m = buoyancyForward_m(f, drive.speed_mps);
    i.yawGyradius_m = 0.25 * L;
    i.mx = -d.Xudot / scale_kg;
    const double m = f.mass_kg() / scale_kg, B = f.beam_m, T = f.draught_m, Cb = f.block;
    const double shape = L * T / (B * B);
    i.my = m * (0.882 - 0.54 * Cb * (1.0 - 1.6 * T / B) - 0.156 * (1.0 - 0.673 * Cb) * L / B +
                0.826 * shape * (1.0 - 0.678 * T / B) - 0.638 * Cb * shape * (1.0 - 0.669 * T / B));
    const double gyradius =
        0.01 * (33.0 - 76.85 * Cb * (1.0 - 0.784 * Cb) + 3.43 * L / B * (1.0 - 0.63 * Cb));
    i.Jz = m * gyradius * gyradius;
    return i;
}

/// Linear terms of Clarke et al. from SI to the MMG method's scales.
void addLinear(MmgHull& h, const Form& f, const Derivatives& d) {
    const double scale = 0.5 * kWater_kgpm3 * f.length_m * f.draught_m, L = f.length_m;
    h.Yv = d.Yv / scale;
    h.Yr = d.Yr / (scale * L);
    h.Nv = d.Nv / (scale * L);
    h.Nr = d.Nr / (scale * L * L);
}

/// What the published Nvvr of KVLCC2 (Yasukawa and Yoshimura 2015) and of KCS (Yasukawa, Sakuno and Yoshimura
/// 2019), -0.294 and -0.560, lie below Kijima's of these ships, both by as much; without it turns are too
/// tight.
constexpr double kMoreNvvr = 0.157;

/// A fin aft; less than none where `lift`, over 1/2 rho L d U v, is negative.
void addFin(MmgHull& h, double lift, double place) {
    h.Yv -= lift;
    h.Yr -= place * lift;
    h.Nv -= place * lift;
    h.Nr -= place * place * lift;
}

/// Skegs, of little span for their length.
double skegLift(const Form& f) {
    constexpr double kLiftSlope = 1.8;
    return kLiftSlope * f.skeg_m2 / (f.length_m * f.draught_m);
}

}  // namespace

double sternLoss(const Form& f) {
    constexpr double kOfFullness = 0.105, kFine = 0.65, kFull = 0.80;
    const double share = std::clamp((f.block - kFine) / (kFull - kFine), 0.0, 1.0);
    return kOfFullness * share * f.block * f.beam_m / f.length_m;
}

MmgHull kijimaNonlinear(double length_m, double beam_m, double draught_m, double block) {
    const double full = block * beam_m / length_m, fine = draught_m * (1.0 - block) / beam_m,
                 deep = draught_m * block / beam_m;
    MmgHull h;  // from drift angle to lateral velocity, beta = -v
    h.Yvv = -(2.5 * fine + 0.5);
    h.Yrr = 0.343 * deep - 0.07;
    h.Yvrr = -5.95 * fine;
    h.Yvvr = 1.5 * deep - 0.65;
    h.Nvv = 0.96 * fine - 0.066;
    h.Nrr = 0.5 * full - 0.09;
    h.Nvrr = 0.5 * full - 0.05;
    h.Nvvr = -(57.5 * full * full - 18.4 * full + 1.6);
    return h;
}

MmgParameters mmgOf(const Form& f, const Drive& drive, const Rudders& rudders) {
    const Derivatives d = derivativesOf(f);
    const double full = f.block * f.beam_m / f.length_m;
    MmgParameters p;
    p.inertia = inertiaOf(f, drive, d);
    MmgHull& h = p.hull = kijimaNonlinear(f.length_m, f.beam_m, f.draught_m, f.block);
    h.Nrr = 0.0;
    h.Nrrr = std::min(0.25 * full - 0.056, -0.015);  // of very beamy hulls it would drive the swing
    addLinear(h, f, d);
    h.Nvvr -= kMoreNvvr;
    addFin(h, skegLift(f), -0.45);
    addFin(h, -sternLoss(f), -0.5);
    h.R0 = drive.resistance_N /
           (0.5 * kWater_kgpm3 * f.length_m * f.draught_m * drive.speed_mps * drive.speed_mps);
    h.Xvv = std::min(0.0, 1.15 * full - 0.18);
    h.Xvvvv = std::max(0.0, 1.1 - 6.68 * full);
    h.Xrr = 0.008 - 0.085 * full;
    h.Xvr = std::max(0.0, 1.91 * full - 0.08) - p.inertia.my;
    p.range.drift_rad = 35.0 * kDegree_rad;
    p.range.yawRate = 1.5;
    p.range.crossFlowDrag = d.crossFlowDrag;
    p.range.asternResistance = 1.5;
    p.wake.C1 = 2.0;
    p.wake.C2port = p.wake.C2starboard = std::min(1.35, 1.0 / (1.0 - drive.wake));
    MmgRudder& r = p.rudder;
    r.height_m = std::sqrt(kRudderAspect * rudders.areaEach_m2);
    r.liftSlope = 6.13 * kRudderAspect / (kRudderAspect + 2.25);
    r.tR = 0.39;
    r.aH = std::max(0.1, 0.627 * f.block - 0.153);
    r.xH = -0.45;
    r.lR = -0.71;
    r.gammaPort = r.gammaStarboard = std::clamp(1.03 * full + 0.25, 0.25, 0.6);
    r.epsilon = std::clamp(0.90 + 3.4 * (full - 0.091), 0.85, 1.15);
    r.kappa = 0.6 / r.epsilon;
    return p;
}

std::vector<AsternSideRow> asternOf(const Form& f, const Drive& drive) {
    constexpr double kLength_m = 3.0, kDraught_m = 0.20114, kDiameter_m = 0.084;  // of the model
    const double scale = drive.diameter_m * drive.diameter_m / (f.length_m * f.draught_m) * kLength_m *
                         kDraught_m / (kDiameter_m * kDiameter_m);
    // A1 + A2 J to J = -0.35, A3 + A4 J astern of it until it ends, A5 from J = -0.06; so B for the moment.
    return {{-0.84, 0.0, 0.0},
            {-0.35, -2.876e-3 * scale, 1.1445e-3 * scale},
            {-0.06, -5.58e-4 * scale, 2.25e-4 * scale}};
}

}  // namespace sagara::core::estimate
