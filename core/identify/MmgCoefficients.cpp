#include <cmath>

#include "core/identify/CoefficientsOf.h"

namespace sagara::core {
namespace {

/// `least`: prior standard deviation where the share of the value is smaller. Our own judgement: about a
/// fifth of what the coefficient is in the published sets of merchant ships, for where she happens to have a
/// small one.
template <typename Group>
struct Row {
    const char* key;
    double Group::*member;
    double least;
    double low, high;
};

constexpr double kD = 20.0;  // as the document's reader
constexpr Row<MmgHull> kHull[] = {
    {"R0", &MmgHull::R0, 0.002, 0.001, 1.0},     {"Xvv", &MmgHull::Xvv, 0.02, -kD, kD},
    {"Xvr", &MmgHull::Xvr, 0.02, -kD, kD},       {"Xrr", &MmgHull::Xrr, 0.005, -kD, kD},
    {"Xvvvv", &MmgHull::Xvvvv, 0.1, -kD, kD},    {"Yv", &MmgHull::Yv, 0.05, -kD, kD},
    {"Yr", &MmgHull::Yr, 0.02, -kD, kD},         {"Yvvv", &MmgHull::Yvvv, 0.3, -kD, kD},
    {"Yvvr", &MmgHull::Yvvr, 0.2, -kD, kD},      {"Yvrr", &MmgHull::Yvrr, 0.1, -kD, kD},
    {"Yrrr", &MmgHull::Yrrr, 0.01, -kD, kD},     {"Nv", &MmgHull::Nv, 0.02, -kD, kD},
    {"Nr", &MmgHull::Nr, 0.01, -kD, kD},         {"Nvvv", &MmgHull::Nvvv, 0.05, -kD, kD},
    {"Nvvr", &MmgHull::Nvvr, 0.06, -kD, kD},     {"Nvrr", &MmgHull::Nvrr, 0.02, -kD, kD},
    {"Nrrr", &MmgHull::Nrrr, 0.005, -kD, kD},    {"Yvv", &MmgHull::Yvv, 0.1, -kD, kD},
    {"Yrr", &MmgHull::Yrr, 0.01, -kD, kD},       {"Nvv", &MmgHull::Nvv, 0.02, -kD, kD},
    {"Nrr", &MmgHull::Nrr, 0.01, -kD, kD},       {"Xrphi", &MmgHull::Xrphi, 0.02, -kD, kD},
    {"Yphi", &MmgHull::Yphi, 0.01, -kD, kD},     {"Yvvphi", &MmgHull::Yvvphi, 0.05, -kD, kD},
    {"Yvrphi", &MmgHull::Yvrphi, 0.05, -kD, kD}, {"Yrrphi", &MmgHull::Yrrphi, 0.02, -kD, kD},
    {"Nphi", &MmgHull::Nphi, 0.005, -kD, kD},    {"Nvvphi", &MmgHull::Nvvphi, 0.02, -kD, kD},
    {"Nvrphi", &MmgHull::Nvrphi, 0.02, -kD, kD}, {"Nrrphi", &MmgHull::Nrrphi, 0.01, -kD, kD},
};
constexpr Row<MmgWake> kWake[] = {
    {"C1", &MmgWake::C1, 0.4, 0.0, 20.0},
    {"C2port", &MmgWake::C2port, 0.1, 0.1, 3.0},
    {"C2starboard", &MmgWake::C2starboard, 0.1, 0.1, 3.0},
};
constexpr Row<MmgRudder> kRudder[] = {
    {"tR", &MmgRudder::tR, 0.05, -0.5, 0.9},
    {"aH", &MmgRudder::aH, 0.05, -0.2, 1.5},
    {"xH", &MmgRudder::xH, 0.05, -1.0, 0.0},
    {"lR", &MmgRudder::lR, 0.1, -2.0, 0.0},
    {"gammaPort", &MmgRudder::gammaPort, 0.08, 0.0, 1.5},
    {"gammaStarboard", &MmgRudder::gammaStarboard, 0.08, 0.0, 1.5},
    {"epsilon", &MmgRudder::epsilon, 0.1, 0.3, 3.0},
    {"kappa", &MmgRudder::kappa, 0.1, 0.0, 1.5},
};

template <typename Group, std::size_t n>
void add(std::vector<Coefficient>& all, const Row<Group> (&rows)[n], const char* name,
         Group MmgParameters::*group, const MmgModel& model, Quality quality) {
    for (const Row<Group>& row : rows) {
        const double value = model.parameters.*group.*row.member;
        if (value == 0.0) continue;
        const auto member = row.member;
        all.push_back({std::string(name) + "." + row.key, true, std::string("/") + name,
                       std::string("/") + row.key,
                       [group, member](Vessel&, NamedModel& m) -> double& {
                           return std::get<MmgModel>(m.parameters).parameters.*group.*member;
                       },
                       std::max(row.least, priorShare(quality) * std::abs(value)), row.low, row.high});
    }
}

}  // namespace

std::vector<Coefficient> mmgCoefficients(const MmgModel& model, const std::set<std::string>& wanted) {
    std::vector<Coefficient> all;
    const auto want = [&](const char* group) { return wanted.empty() || wanted.count(group) > 0; };
    if (want("hull")) add(all, kHull, "hull", &MmgParameters::hull, model, model.sources.hull.quality);
    if (want("wake")) add(all, kWake, "wake", &MmgParameters::wake, model, model.sources.wake.quality);
    if (want("rudder"))
        add(all, kRudder, "rudder", &MmgParameters::rudder, model, model.sources.rudder.quality);
    return all;
}

}  // namespace sagara::core
