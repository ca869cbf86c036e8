#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/vessel/MmgModel.h"
#include "core/vessel/PolynomialModel.h"
#include "core/vessel/Provenance.h"
#include "core/vessel/TransferModel.h"

/// Parameters of the manoeuvring models a vessel document can carry. The physics is in core/motion.
namespace sagara::core {

/// One alternative for each kind of model.
using ShipModel =
    std::variant<PolynomialModel, NomotoModel, BarauskisModel, UengModel, SandaruwanModel, MmgModel>;

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
/// What the model makes of waves.
WaveFeeling wavesOf(const ShipModel& model);

/// Heave, pitch and, where the manoeuvring model has none, roll: added mass and damping as ratios.
struct Seakeeping {
    double heaveAddedMassRatio = 0.0;  ///< over the ship's mass
    double heaveDampingRatio = 0.0;    ///< of critical
    double pitchAddedInertiaRatio = 0.0;
    double pitchDampingRatio = 0.0;
    double rollAddedInertiaRatio = 0.0;
    double rollDampingRatio = 0.0;
    bool instantaneousHull = false;  ///< restoring and undisturbed waves on the hull as she is wetted
    Provenance provenance;
};
Seakeeping readSeakeeping(config::Reader& in);

}  // namespace sagara::core
