#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/Result.h"
#include "core/vessel/DeckGear.h"
#include "core/vessel/Hull.h"
#include "core/vessel/Machinery.h"
#include "core/vessel/Picture.h"
#include "core/vessel/PlaningHull.h"
#include "core/vessel/ShallowWater.h"
#include "core/vessel/ShipModel.h"
#include "core/vessel/Thrusters.h"
#include "core/vessel/Windage.h"

namespace sagara::core {

inline constexpr int kVesselDocumentVersion = 1;

/// Everything a vessel document says, in SI and frame B. Plain data: what is worked out from it is made by
/// core/motion.
struct Vessel {
    std::string id;
    std::string name;
    std::string type;  ///< "patrol", "tanker", ...: free text for people
    BodyPoint bridgeEye;
    double bridgeEyeHeight_m = 0.0;
    Hull hull;
    std::optional<PlaningHull> planing;  ///< none: she floats at any speed
    std::vector<NamedModel> models;      ///< at least one; the first is the default
    Seakeeping seakeeping;
    Propulsion propulsion;
    Steering steering;
    Thrusters thrusters;  ///< may have none
    Windage windage;
    ShallowWater shallow;
    MooringGear mooring;
    GroundTackle groundTackle;
    std::optional<Picture> picture;  ///< none: drawn from her form

    /// The model of that name, for an empty name the first; or what is wrong with the name and which there
    /// are.
    Result<const NamedModel*, std::string> model(std::string_view modelName = {}) const;
};

/// All problems of the document at once. `name` is used in messages: a file name or an id. What a document
/// with "particulars" lacks is estimated: completeVessel.
Result<Vessel, config::Problems> loadVessel(const std::string& name, std::string_view text);

}  // namespace sagara::core
