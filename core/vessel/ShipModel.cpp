#include "core/vessel/ShipModel.h"

#include <type_traits>

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

template <auto read>
ShipModel readAs(config::Reader& in) {
    return read(in);
}

}  // namespace

NamedModel readShipModel(config::Reader& in) {
    using Read = ShipModel (*)(config::Reader&);
    const auto read = in.choiceIfKnown<Read>("kind", {{"polynomial", readAs<readPolynomial>},
                                                      {"nomoto", readAs<readNomoto>},
                                                      {"barauskis2007", readAs<readBarauskis>},
                                                      {"ueng2008", readAs<readUeng>},
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

WaveFeeling wavesOf(const ShipModel& model) {
    return std::visit(
        [](const auto& m) {
            if constexpr (std::is_base_of_v<TransferModel, std::decay_t<decltype(m)>>)
                return m.waves;
            else
                return WaveFeeling::Pressure;
        },
        model);
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
    if (in.has("wettedHull"))
        s.instantaneousHull = in.choice<bool>("wettedHull", {{"mean", false}, {"instantaneous", true}});
    s.provenance = readProvenance(in);
    in.rejectUnknownKeys();
    return s;
}

}  // namespace sagara::core
