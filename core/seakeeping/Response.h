#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/seakeeping/LateralRadiation.h"
#include "core/seakeeping/MakeTables.h"
#include "core/seakeeping/StripTheory.h"

namespace sagara::core {

/// Steady motions in one regular wave, linear but for the viscous roll damping, which goes with the
/// amplitude.
struct WaveResponse {
    double omega_radps = 0.0;
    double encounter_radps = 0.0;  ///< below nothing where the ship overtakes the waves
    double lambdaOverL = 0.0;
    Complex6
        atGravity;  ///< per metre of wave amplitude, frame B (heave down, pitch bow up), crest at G at t = 0
    double rollAmplitude_rad = 0.0;
};

/// (-w^2 (mass + added) + i w damping + restoring) motion = force, about Bo.
struct MotionEquation {
    Matrix6 mass;
    AddedMassAndDamping radiation;
    Matrix6 restoring;
    double extraRollDamping_Nms = 0.0;
};
Complex6 solved(const MotionEquation& equation, double omega_radps, const Complex6& force);

/// Motions of Bo and the crest there -> of the centre of gravity and the crest there. Of a wave overtaken at
/// the positive frequency.
Complex6 atGravity(const HullForm& form, const MetWave& wave, const Complex6& atBo);

/// Each strip is solved at the very frequency of encounter; nothing is interpolated.
class HullResponse {
public:
    explicit HullResponse(const HullForm& form, const TableOptions& options = {});

    /// In a wave of this height, crest to trough.
    WaveResponse respond(const MetWave& wave, double waveHeight_m) const;

private:
    HullForm m_form;
    TableOptions m_options;
    StripHull m_hull;
    LateralRadiation m_lateral;
    IkedaShip m_ikeda;
    Matrix6 m_mass;
    Matrix6 m_restoring;
};

/// Roll at one amplitude, all nothing where the ship does not stand upright.
struct RollMode {
    double omega_radps = 0.0;    ///< natural
    double potential_Nms = 0.0;  ///< damping by radiated waves about the axis she rolls about
    double viscous_Nms = 0.0;    ///< at the amplitude
    double dampingRatio = 0.0;   ///< of critical, both together
};
/// Free roll of the upright ship at zero speed, the other five motions going along.
class FreeRoll {
public:
    /// Makes the radiation it needs: half a second.
    explicit FreeRoll(const HullForm& form);
    FreeRoll(const HullForm& form, const StripHull& hull, const LateralRadiation& lateral);

    RollMode at(double amplitude_rad) const;

private:
    IkedaShip m_ikeda;
    double m_waterDensity_kgpm3;
    double m_volume_m3;
    double m_added_Nms;
    RollMode m_undamped;  ///< but for the radiated waves
    double m_critical_Nms = 0.0;
};

/// The table below of responses at hand.
std::string raoTable(const std::vector<WaveResponse>& responses, double lengthBp_m);

/// Rows of `omega_radps,omega_e_radps,lambda_over_L,surge,sway,heave,roll_k,pitch_k,yaw_k` and the six
/// phases: over the wave's amplitude, angles over its slope; degrees of lead over the crest at the centre of
/// gravity, in frame B. Without a wave height it is Lpp / 50.
std::string raoTable(const HullForm& form, double speed_mps, double relativeHeading_rad,
                     const std::vector<double>& omegas_radps, std::optional<double> waveHeight_m,
                     const TableOptions& options = {});

}  // namespace sagara::core
