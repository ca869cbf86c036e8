#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/vessel/MmgModel.h"
#include "core/vessel/PolynomialModel.h"
#include "core/vessel/Provenance.h"

/// Parameters of the manoeuvring models a vessel document can carry. The physics is in core/motion.
namespace sagara::core {

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

/// Where a published model holds; elsewhere another model of the vessel takes over, smoothly in between.
struct HoldsIn {
    double from_mps = 0.0;  ///< surge speed through the water, ahead
    double to_mps = 0.0;
    double nothingBelow_mps = 0.0;  ///< here and slower the other model has taken over
    double nothingAbove_mps = 0.0;  ///< here and faster
    double shaftFrom_rps = 0.0;     ///< mean shaft speed ahead from which on it holds; nothing is left at 0
    std::string elsewhere;          ///< name of the other model
};

/// One of the models a vessel can be run with.
struct NamedModel {
    std::string name;  ///< its kind, such as "polynomial", unless the document names it
    Provenance provenance;
    ShipModel parameters;
    std::optional<HoldsIn> holds;  ///< none: at any speed
    bool headingFollowsRoll =
        false;  ///< heading changes by r cos(phi), as published with some sets; else by r
};
NamedModel readShipModel(config::Reader& in);

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
