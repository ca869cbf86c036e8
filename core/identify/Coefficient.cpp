#include "core/identify/Coefficient.h"

#include "core/identify/CoefficientsOf.h"

namespace sagara::core {

double priorShare(Quality quality) {
    return quality == Quality::Measured || quality == Quality::Published ? 0.3 : 0.5;
}

std::set<std::string> coefficientGroupsOf(const NamedModel& model) {
    if (std::holds_alternative<MmgModel>(model.parameters)) return {"hull", "wake", "rudder", "astern"};
    if (std::holds_alternative<PolynomialModel>(model.parameters))
        return {"turning", "resistance", "roll", "astern"};
    return {"turning", "resistance", "astern"};
}

std::vector<Coefficient> coefficientsOf(const NamedModel& model, const std::set<std::string>& wanted) {
    if (const auto* mmg = std::get_if<MmgModel>(&model.parameters)) return mmgCoefficients(*mmg, wanted);
    if (std::holds_alternative<PolynomialModel>(model.parameters))
        return polynomialCoefficients(model, wanted);
    return transferCoefficients(model, wanted);
}

std::vector<Coefficient> sternwardCoefficients(const Vessel& vessel) {
    std::vector<Coefficient> all;
    const double share = priorShare(vessel.propulsion.provenance.quality);
    for (std::size_t i = 0; i < vessel.propulsion.units.size(); ++i) {
        const PropulsionUnit& unit = vessel.propulsion.units[i];
        if (unit.openWater || unit.asternThrustRatio == 0.0) continue;
        all.push_back(
            {"propulsion." + unit.id + ".asternThrustRatio", false, "/propulsion",
             "/units/" + std::to_string(i) + "/asternThrustRatio",
             [i](Vessel& v, NamedModel&) -> double& { return v.propulsion.units[i].asternThrustRatio; },
             share* unit.asternThrustRatio, 0.2, 1.0});
    }
    return all;
}

}  // namespace sagara::core
