#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/vessel/MmgModel.h"
#include "core/vessel/Provenance.h"

/// Parameters of the manoeuvring models a vessel document can carry. The physics is in core/motion.
namespace sagara::core {

/// One row of a published polynomial: a product of at most four motion quantities and its coefficient in each
/// force.
struct PolynomialTerm {
    /// Quantities a factor can name. Abs... is the absolute value.
    enum class Factor : std::uint8_t {
        One,
        Surge,
        Sway,
        YawRate,
        RollRate,
        Roll,
        AbsSurge,
        AbsSway,
        AbsYawRate,
        AbsRollRate,
        AbsRoll
    };
    std::array<Factor, 4> factors{};
    double surge = 0.0;        ///< X, SI
    double sway = 0.0;         ///< Y
    double roll = 0.0;         ///< K
    double yaw = 0.0;          ///< N
    bool crossFlow = false;    ///< fades out below the published range, where cross-flow drag takes over
    bool turnsAstern = false;  ///< changes sign with the direction of motion (an even |u| that stands for u)
};

/// A published set of hull derivatives in 4 degrees of freedom, with the rigid body and added mass it goes
/// with, the rudder and thrust rule it was published with and the range of speed it holds in.
struct PolynomialModel {
    double mass_kg = 0.0;
    double xG_m = 0.0;
    double zG_m = 0.0;
    double rollInertia_kgm2 = 0.0;
    double yawInertia_kgm2 = 0.0;
    /// Added mass with the sign of the derivative (Xudot is negative).
    double Xudot = 0.0, Yvdot = 0.0, Ypdot = 0.0, Yrdot = 0.0;
    double Kvdot = 0.0, Kpdot = 0.0, Krdot = 0.0;
    double Nvdot = 0.0, Npdot = 0.0, Nrdot = 0.0;
    std::vector<PolynomialTerm> terms;
    double rudderYawLever_m = 0.0;   ///< moment of the rudder force about Bo, abaft midship
    double rudderRollLever_m = 0.0;  ///< of the inward heel
    /// Published thrust: independent of speed, this much in all at this shaft speed, with its square at
    /// others.
    double publishedThrust_N = 0.0;
    double publishedShaft_rps = 1.0;
    double holdsFrom_mps = 0.0;  ///< published range of speed ahead
    double holdsTo_mps = 0.0;
    double extensionBelow_mps =
        0.0;  ///< the low-speed extension is whole below this speed, nothing from holdsFrom on
    double crossFlowDrag = 0.0;  ///< coefficient at rest
};

/// Corrected model of Sandaruwan et al. (2010): non-linear surge, Nomoto yaw, first-order sway driven by yaw.
struct SandaruwanModel {
    double gain_perS = 0.0;           ///< K at the reference speed
    double timeConstant_s = 1.0;      ///< tau at the reference speed
    double swayGain_m = 0.0;          ///< K_v; negative: the stern swings out
    double swayTimeConstant_s = 1.0;  ///< tau_v at the reference speed
    double referenceSpeed_mps = 1.0;
    bool scalesWithSpeed = true;  ///< K ~ U, tau ~ 1/U (audit, eq 4); false is the paper's constant K and tau
    double surgeAddedMassRatio = 0.05;
    double resistance_kgpm = 0.0;     ///< X_uu
    double surgeFromTurn_kg = 0.0;    ///< X_vr
    double swayAddedMassRatio = 0.8;  ///< for loads from outside the model
    double yawAddedInertiaRatio = 0.8;
    double crossFlowDrag = 0.0;
};

/// One alternative for each kind of model.
using ShipModel = std::variant<PolynomialModel, SandaruwanModel, MmgModel>;

/// One of the models a vessel can be run with.
struct NamedModel {
    std::string name;  ///< its kind, such as "polynomial", unless the document names it
    Provenance provenance;
    ShipModel parameters;
};
NamedModel readShipModel(config::Reader& in);

/// "phi |u| v", "r^2": factors separated by spaces; false when it is not that or has more than four.
bool parseFactors(const std::string& text, std::array<PolynomialTerm::Factor, 4>& factors);

/// Heave, pitch and, where the manoeuvring model has none, roll: added mass and damping as ratios.
struct Seakeeping {
    double heaveAddedMassRatio = 0.0;  ///< over the ship's mass
    double heaveDampingRatio = 0.0;    ///< of critical
    double pitchAddedInertiaRatio = 0.0;
    double pitchDampingRatio = 0.0;
    double rollAddedInertiaRatio = 0.0;
    double rollDampingRatio = 0.0;
    Provenance provenance;
};
Seakeeping readSeakeeping(config::Reader& in);

}  // namespace sagara::core
