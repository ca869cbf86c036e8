#include "core/vessel/ShipModel.h"

namespace sagara::core {
namespace {

HoldsIn readHolds(const config::Node& node) {
    config::Reader in(node);
    HoldsIn h;
    const config::Range speed{0.0, 60.0, "m/s"};
    h.from_mps = in.number("from_mps", speed);
    h.to_mps = in.number("to_mps", speed);
    h.nothingBelow_mps = in.number("nothingBelow_mps", speed);
    h.nothingAbove_mps = in.number("nothingAbove_mps", speed);
    h.shaftFrom_rps = in.number("shaftFrom_rps", {0.01, 50.0, "1/s"});
    h.elsewhere = in.text("elsewhere");
    const bool rising =
        h.nothingBelow_mps < h.from_mps && h.from_mps < h.to_mps && h.to_mps < h.nothingAbove_mps;
    if (in.sound() && !rising)
        in.problem("from_mps", "is " + config::formatNumber(h.from_mps),
                   "nothingBelow_mps, from_mps, to_mps and nothingAbove_mps in rising order");
    in.rejectUnknownKeys();
    return h;
}

SandaruwanModel readSandaruwan(config::Reader& in) {
    SandaruwanModel m;
    m.gain_perS = in.number("gain_perS", {1e-5, 2.0, "1/s"});
    m.timeConstant_s = in.number("timeConstant_s", {0.5, 2000.0, "s"});
    m.swayGain_m = in.number("swayGain_m", {-400.0, 0.0, "m"});
    m.swayTimeConstant_s = in.number("swayTimeConstant_s", {0.1, 1000.0, "s"});
    m.referenceSpeed_mps = in.number("referenceSpeed_mps", {0.5, 30.0, "m/s"});
    m.scalesWithSpeed = in.flagOr("scalesWithSpeed", true);
    m.surgeAddedMassRatio = in.number("surgeAddedMassRatio", {0.0, 0.5, ""});
    m.resistance_kgpm = in.number("resistance_kgpm", {1.0, 1e7, "kg/m"});
    m.surgeFromTurn_kg = in.number("surgeFromTurn_kg", {0.0, 1e9, "kg"});
    m.swayAddedMassRatio = in.number("swayAddedMassRatio", {0.1, 3.0, ""});
    m.yawAddedInertiaRatio = in.number("yawAddedInertiaRatio", {0.1, 3.0, ""});
    m.crossFlowDrag = in.number("crossFlowDrag", {0.0, 3.0, ""});
    return m;
}

template <auto read>
ShipModel readAs(config::Reader& in) {
    return read(in);
}

}  // namespace

NamedModel readShipModel(config::Reader& in) {
    using Read = ShipModel (*)(config::Reader&);
    const auto read = in.choiceIfKnown<Read>("kind", {{"polynomial", readAs<readPolynomial>},
                                                      {"sandaruwan2010", readAs<readSandaruwan>},
                                                      {"mmg", readAs<readMmg>}});
    const std::string name = in.has("name") ? in.id("name") : in.textOr("kind", "");
    const Provenance provenance = readProvenance(in);
    NamedModel model{name, provenance, {}, {}, false};
    if (!read) return model;
    model.parameters = (*read)(in);
    if (in.has("holds")) model.holds = readHolds(in.child("holds"));
    model.headingFollowsRoll = in.flagOr("headingFollowsRoll", false);
    in.rejectUnknownKeys();
    return model;
}

Seakeeping readSeakeeping(config::Reader& in) {
    Seakeeping s;
    const config::Range ratio{0.0, 5.0, ""}, damping{0.005, 1.5, ""};
    s.heaveAddedMassRatio = in.number("heaveAddedMassRatio", ratio);
    s.heaveDampingRatio = in.number("heaveDampingRatio", damping);
    s.pitchAddedInertiaRatio = in.number("pitchAddedInertiaRatio", ratio);
    s.pitchDampingRatio = in.number("pitchDampingRatio", damping);
    s.rollAddedInertiaRatio = in.number("rollAddedInertiaRatio", ratio);
    s.rollDampingRatio = in.number("rollDampingRatio", damping);
    s.provenance = readProvenance(in);
    in.rejectUnknownKeys();
    return s;
}

}  // namespace sagara::core
