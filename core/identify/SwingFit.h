#pragma once

#include "core/identify/SeaTrial.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

/// Roll, pitch or heave as a swing of its own,
///   x'' + 2 zeta w x' + d x' |x'| + w^2 x = wave,
/// fitted to decays and motion logs by output error. The form of roll damping is that of Himeno (1981),
/// "Prediction of ship roll damping", Univ. of Michigan report 239 (linear and quadratic;
/// ITTC 7.5-02-07-04.5); heave and pitch have no d. Waves: roll is driven by the effective slope (Froude
/// 1861; Conolly 1969), heave and pitch by the water's height or slope, velocity and acceleration relative to
/// the ship (as core/motion does), each with a size and a phase that the fit finds, for probes are never
/// quite at midship. How well each record can be followed is found by a first fit and taken as its noise in a
/// second.
struct SwingFit {
    Channel motion = Channel::Roll;
    double frequency_radps = 0.0, frequencyDeviation_radps = 0.0;
    double linear = 0.0, linearDeviation = 0.0;        ///< zeta, of critical
    double quadratic = 0.0, quadraticDeviation = 0.0;  ///< d, 1/rad
    double amplitude = 0.0;                            ///< typical of the records: rms times sqrt 2, rad or m
    double rms = 0.0;                                  ///< of what is left, rad or m
    std::vector<std::string> trials;

    /// Of critical, with the same loss over a swing of this amplitude: zeta + 4 d a / (3 pi).
    double equivalent(double atAmplitude) const;
    double equivalentDeviation(double atAmplitude) const;
    /// Whether the records tell the damping to a third of itself.
    bool told() const;

    /// Variances of linear and quadratic together.
    double covariance = 0.0;
};

/// Roll damping as a moment, -(linear + quadratic |p|) p: the form that core/seakeeping calls viscous roll.
/// Of all damping that was measured, that by radiated waves included.
struct RollMoment {
    double linear_Nms = 0.0;
    double quadratic_Nms2 = 0.0;
};
RollMoment rollMomentOf(const SwingFit& roll, const Hull& hull);

/// From all decays and motion logs that have this motion (decays: roll alone); none where there are none or
/// none that could be followed. `vessel` gives the first guess of frequency and damping.
std::optional<SwingFit> fitSwing(const Vessel& vessel, const std::vector<SeaTrial>& trials, Channel motion);

}  // namespace sagara::core
