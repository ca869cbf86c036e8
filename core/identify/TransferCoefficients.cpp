#include <cassert>
#include <cmath>

#include "core/identify/CoefficientsOf.h"

namespace sagara::core {
namespace {

struct Row {
    const char* key;
    double TransferModel::*member;
    const char* group;
    double low, high;  ///< as the document's reader
};
constexpr Row kRows[] = {
    {"gain_perS", &TransferModel::gain_perS, "turning", 1e-5, 2.0},
    {"timeConstant_s", &TransferModel::timeConstant_s, "turning", 0.5, 2000.0},
    {"norrbin3_s2", &TransferModel::cubic_s2, "turning", 0.0, 1e7},
    {"swayGain_m", &TransferModel::swayGain_m, "turning", -400.0, 0.0},
    {"swayTimeConstant_s", &TransferModel::swayTimeConstant_s, "turning", 0.1, 1000.0},
    {"resistance_kgpm", &TransferModel::resistance_kgpm, "resistance", 1.0, 1e7},
    {"surgeFromTurn_kg", &TransferModel::surgeFromTurn_kg, "resistance", 0.0, 1e9},
};

/// Of a model that is one of them.
TransferModel& transferOf(NamedModel& model) {
    TransferModel* found = nullptr;
    std::visit(
        [&found](auto& m) {
            if constexpr (std::is_base_of_v<TransferModel, std::decay_t<decltype(m)>>) found = &m;
        },
        model.parameters);
    assert(found);
    return *found;
}

/// Nomoto's and Ueng's documents say nothing of sway.
bool saysSway(const NamedModel& model) {
    return !std::holds_alternative<NomotoModel>(model.parameters) &&
           !std::holds_alternative<UengModel>(model.parameters);
}

}  // namespace

std::vector<Coefficient> transferCoefficients(const NamedModel& model, const std::set<std::string>& wanted) {
    std::vector<Coefficient> all;
    NamedModel copy = model;
    constexpr double kShare = 0.5;  // constants of a simple model are fitted to one speed or one manoeuvre
    for (const Row& row : kRows) {
        const double value = transferOf(copy).*row.member;
        const bool sways = row.key[0] == 's';
        if (value == 0.0 || (sways && !saysSway(model))) continue;
        if (!wanted.empty() && wanted.count(row.group) == 0) continue;
        const auto member = row.member;
        all.push_back({row.key, true, "", std::string("/") + row.key,
                       [member](Vessel&, NamedModel& m) -> double& { return transferOf(m).*member; },
                       kShare* std::abs(value), row.low, row.high});
    }
    return all;
}

}  // namespace sagara::core
