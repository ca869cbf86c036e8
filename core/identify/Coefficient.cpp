#include "core/identify/Coefficient.h"

#include "core/identify/CoefficientsOf.h"

namespace sagara::core {

double priorShare(Quality quality) {
    return quality == Quality::Measured || quality == Quality::Published ? 0.3 : 0.5;
}

std::set<std::string> coefficientGroupsOf(const NamedModel& model) {
    if (std::holds_alternative<MmgModel>(model.parameters)) return {"hull", "wake", "rudder"};
    if (std::holds_alternative<PolynomialModel>(model.parameters)) return {"turning", "resistance", "roll"};
    return {"turning", "resistance"};
}

std::vector<Coefficient> coefficientsOf(const NamedModel& model, const std::set<std::string>& wanted) {
    if (const auto* mmg = std::get_if<MmgModel>(&model.parameters)) return mmgCoefficients(*mmg, wanted);
    if (std::holds_alternative<PolynomialModel>(model.parameters))
        return polynomialCoefficients(model, wanted);
    return transferCoefficients(model, wanted);
}

}  // namespace sagara::core
