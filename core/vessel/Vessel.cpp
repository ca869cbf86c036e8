#include "core/vessel/Vessel.h"

#include <algorithm>

#include "core/vessel/CompleteVessel.h"
#include "core/vessel/Plausible.h"
#include "core/vessel/ReadPoint.h"

namespace sagara::core {
namespace {

/// Reads one group of the document with its own reader.
template <typename T>
T readGroup(config::Reader& in, const char* key, T (*read)(config::Reader&)) {
    config::Reader group(in.child(key));
    return read(group);
}

/// What a model hands over to is there and hands over to no other.
void checkElsewhere(config::Reader& in, const std::vector<NamedModel>& models) {
    for (const NamedModel& m : models) {
        if (!m.holds) continue;
        const bool there = std::any_of(models.begin(), models.end(), [&](const NamedModel& other) {
            return other.name == m.holds->elsewhere && !other.holds;
        });
        if (!there)
            in.problem("models",
                       "has model \"" + m.name + "\" that hands over to \"" + m.holds->elsewhere + "\"",
                       "a model of this vessel that holds at any speed");
    }
}

/// "models", a list in order of preference, or a single "model".
std::vector<NamedModel> readModels(config::Reader& in) {
    if (!in.has("models") && !in.has("model")) {
        in.problem("model", "is missing",
                   "a manoeuvring model, or \"particulars\" from which one is estimated");
        return {};
    }
    if (!in.has("models")) {
        const std::vector<NamedModel> one{readGroup(in, "model", readShipModel)};
        checkElsewhere(in, one);
        return one;
    }
    std::vector<NamedModel> models;
    for (const config::Node& node : in.list("models")) {
        config::Reader group(node);
        NamedModel model = readShipModel(group);
        const bool taken =
            std::any_of(models.begin(), models.end(), [&](const auto& m) { return m.name == model.name; });
        if (taken)
            group.problem("name", "is \"" + model.name + "\" again", "a name of its own for each model");
        models.push_back(std::move(model));
    }
    if (models.empty()) in.problem("models", "is empty", "at least one model");
    checkElsewhere(in, models);
    return models;
}

}  // namespace

Result<const NamedModel*, std::string> Vessel::model(std::string_view modelName) const {
    std::string known;
    for (const NamedModel& m : models) {
        if (modelName.empty() || m.name == modelName) return &m;
        known += (known.empty() ? "" : ", ") + m.name;
    }
    return "vessel " + id + " has no model \"" + std::string(modelName) + "\"; there are: " + known;
}

Result<Vessel, config::Problems> loadVessel(const std::string& name, std::string_view text) {
    const auto whole = completeVessel(name, text);
    if (!whole) return whole.error();
    config::Document document(name, *whole);
    if (!document.isKind("vessel", kVesselDocumentVersion)) return document.problems();
    config::Reader in(document.root());
    in.text("document");
    in.integer("version", 1, kVesselDocumentVersion);
    Vessel v;
    v.id = in.id("id");
    v.name = in.text("name");
    v.type = in.text("type");
    config::Reader eye(in.child("bridgeEye"));
    v.bridgeEye = readBodyPoint(eye);
    v.bridgeEyeHeight_m = eye.number("height_m", {0.5, 80.0, "m"});
    eye.rejectUnknownKeys();
    v.hull = readGroup(in, "hull", readHull);
    if (in.has("planing")) v.planing = readGroup(in, "planing", readPlaningHull);
    v.models = readModels(in);
    v.seakeeping = readGroup(in, "seakeeping", readSeakeeping);
    v.propulsion = readGroup(in, "propulsion", readPropulsion);
    v.steering = readGroup(in, "steering", readSteering);
    const auto turns = [](const PropulsionUnit& unit) { return unit.azimuth.has_value(); };
    if (in.sound() && v.steering.rudders.empty() &&
        std::none_of(v.propulsion.units.begin(), v.propulsion.units.end(), turns))
        in.problem("steering.rudders", "is empty", "at least one rudder, or an azimuth drive");
    if (in.has("thrusters")) v.thrusters = readGroup(in, "thrusters", readThrusters);
    v.windage = readGroup(in, "windage", readWindage);
    if (v.windage.isherwood) v.windage.isherwood->beam_m = v.hull.beam_m;
    if (in.has("shallowWater")) v.shallow = readGroup(in, "shallowWater", readShallowWater);
    v.mooring = readGroup(in, "mooring", readMooringGear);
    v.groundTackle = readGroup(in, "groundTackle", readGroundTackle);
    if (in.has("picture")) v.picture = readGroup(in, "picture", readPicture);
    if (in.sound()) checkPlausible(in, v);
    in.rejectUnknownKeys();
    return document.finish(std::move(v));
}

}  // namespace sagara::core
