#pragma once

#include <cstdint>

#include "core/base/Config.h"

/// Parameters of the models that turn and drift by transfer functions. The physics is in core/motion.
namespace sagara::core {

/// What a model makes of waves.
enum class WaveFeeling : std::uint8_t {
    Pressure,  ///< the tables of her hull
    Blind,
    Heights,        ///< pushed by the heights of the surface over her waterplane, as Ueng et al. (2008)
    HeightsPrinted  ///< as printed in Sandaruwan et al. (2010): no gravity, no restoring
};

/// Surge with resistance, Nomoto yaw with a Norrbin term, first-order sway driven by yaw:
///   (M + added) u' = thrust - X_uu u|u| + (M + X_vr) v r
///   tau r' + n1 r + n3 r^3 = K delta
///   tau_v v' + v = K_v (tau r' + r)
struct TransferModel {
    enum class TurningLoss : std::uint8_t { Corrected, None, Printed };  ///< Printed: -(M - X_vr) v r

    double gain_perS = 0.0;           ///< K at the reference speed
    double timeConstant_s = 1.0;      ///< tau at the reference speed
    double linear = 1.0;              ///< n1: 1, or -1 for a ship that is not stable on her course
    double cubic_s2 = 0.0;            ///< n3 at the reference speed
    double swayGain_m = 0.0;          ///< K_v; negative: the stern swings out
    double swayTimeConstant_s = 1.0;  ///< tau_v at the reference speed
    double referenceSpeed_mps = 1.0;
    bool scalesWithSpeed = true;  ///< K ~ U, tau ~ 1/U, n3 ~ 1/U^2 (audit of the paper, eq 4)
    double surgeAddedMassRatio = 0.05;
    double resistance_kgpm = 0.0;   ///< X_uu
    double surgeFromTurn_kg = 0.0;  ///< X_vr
    TurningLoss turningLoss = TurningLoss::Corrected;
    double swayAddedMassRatio = 0.8;  ///< for loads from outside the model
    double yawAddedInertiaRatio = 0.8;
    double crossFlowDrag = 0.0;
    WaveFeeling waves = WaveFeeling::Pressure;
    double heaveDamping_perm = 0.0;                          ///< K_h, printed form alone
    double pitchDamping_perS = 0.0, rollDamping_perS = 0.0;  ///< K_p, K_r, printed form alone
};

/// Nomoto et al. (1957) with the term of Norrbin (1963), scaled with speed. The ship loses no speed in a turn
/// and does not drift in it.
struct NomotoModel : TransferModel {};
/// Barauskis and Friis-Hansen (2007): knows no waves.
struct BarauskisModel : TransferModel {};
/// Ueng et al. (2008): six degrees of freedom, pushed by wave heights, yaw and sway not coupled.
struct UengModel : TransferModel {};
/// Sandaruwan et al. (2010), corrected, or with the switch `printed` as it was printed.
struct SandaruwanModel : TransferModel {};

NomotoModel readNomoto(config::Reader& in);
BarauskisModel readBarauskis(config::Reader& in);
UengModel readUeng(config::Reader& in);
SandaruwanModel readSandaruwan(config::Reader& in);

}  // namespace sagara::core
