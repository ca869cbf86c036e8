#include <cmath>

#include "core/identify/CoefficientsOf.h"

namespace sagara::core {
namespace {

constexpr double kAny = 1e15;  // as the document's reader

struct Column {
    const char* key;
    double PolynomialTerm::*member;
};
constexpr Column kColumns[] = {{"X", &PolynomialTerm::surge},
                               {"Y", &PolynomialTerm::sway},
                               {"K", &PolynomialTerm::roll},
                               {"N", &PolynomialTerm::yaw}};

const char* groupOf(const Column& column) {
    return column.member == &PolynomialTerm::surge  ? "resistance"
           : column.member == &PolynomialTerm::roll ? "roll"
                                                    : "turning";
}

}  // namespace

std::vector<Coefficient> polynomialCoefficients(const NamedModel& model,
                                                const std::set<std::string>& wanted) {
    std::vector<Coefficient> all;
    const auto& terms = std::get<PolynomialModel>(model.parameters).terms;
    for (std::size_t i = 0; i < terms.size(); ++i)
        for (const Column& column : kColumns) {
            const double value = terms[i].*column.member;
            if (value == 0.0 || (!wanted.empty() && wanted.count(groupOf(column)) == 0)) continue;
            const std::string place = std::to_string(i);
            const auto member = column.member;
            all.push_back({"terms[" + place + "]." + column.key, true, "",
                           "/terms/" + place + "/" + column.key,
                           [i, member](Vessel&, NamedModel& m) -> double& {
                               return std::get<PolynomialModel>(m.parameters).terms[i].*member;
                           },
                           priorShare(model.provenance.quality) * std::abs(value), -kAny, kAny});
        }
    return all;
}

}  // namespace sagara::core
