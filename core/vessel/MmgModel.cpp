#include "core/vessel/MmgModel.h"

#include "core/base/Units.h"

namespace sagara::core {
namespace {

constexpr config::Range kDerivative{-20.0, 20.0, ""};

MmgInertia readInertia(const config::Node& node, Provenance& source) {
    config::Reader in(node);
    MmgInertia i;
    i.xG_m = in.number("xG_m", {-50.0, 50.0, "m"});
    i.yawGyradius_m = in.number("yawGyradius_m", {0.1, 150.0, "m"});
    i.mx = in.number("mx", {0.0, 1.0, ""});
    i.my = in.number("my", {0.0, 3.0, ""});
    i.Jz = in.number("Jz", {0.0, 0.5, ""});
    source = readProvenance(in);
    in.rejectUnknownKeys();
    return i;
}

MmgHull readHullDerivatives(const config::Node& node, Provenance& source) {
    config::Reader in(node);
    MmgHull h;
    h.R0 = in.number("R0", {0.001, 1.0, ""});
    for (const auto& [key, value] : {std::pair{"Yv", &h.Yv}, {"Yr", &h.Yr}, {"Nv", &h.Nv}, {"Nr", &h.Nr}})
        *value = in.number(key, kDerivative);
    for (const auto& [key, value] :
         {std::pair{"Xvv", &h.Xvv}, {"Xvr", &h.Xvr},   {"Xrr", &h.Xrr},       {"Xvvvv", &h.Xvvvv},
          {"Xrphi", &h.Xrphi},      {"Yvvv", &h.Yvvv}, {"Yvvr", &h.Yvvr},     {"Yvrr", &h.Yvrr},
          {"Yrrr", &h.Yrrr},        {"Nvvv", &h.Nvvv}, {"Nvvr", &h.Nvvr},     {"Nvrr", &h.Nvrr},
          {"Nrrr", &h.Nrrr},        {"Yphi", &h.Yphi}, {"Yvvphi", &h.Yvvphi}, {"Yvrphi", &h.Yvrphi},
          {"Yrrphi", &h.Yrrphi},    {"Nphi", &h.Nphi}, {"Nvvphi", &h.Nvvphi}, {"Nvrphi", &h.Nvrphi},
          {"Nrrphi", &h.Nrrphi},    {"Yvv", &h.Yvv},   {"Yrr", &h.Yrr},       {"Nvv", &h.Nvv},
          {"Nrr", &h.Nrr}})
        *value = in.numberOr(key, 0.0, kDerivative);
    source = readProvenance(in);
    in.rejectUnknownKeys();
    return h;
}

MmgRange readRange(const config::Node& node, Provenance& source) {
    config::Reader in(node);
    MmgRange r;
    r.drift_rad = kDegree_rad * in.number("drift_deg", {0.0, 60.0, "deg"});
    r.yawRate = in.number("yawRate", {0.0, 3.0, ""});
    r.crossFlowDrag = in.number("crossFlowDrag", {0.1, 3.0, ""});
    r.crossFlowSwayLever = in.numberOr("crossFlowSwayLever", 1.0, {0.0, 3.0, ""});
    r.crossFlowYawLever = in.numberOr("crossFlowYawLever", 1.0, {0.0, 3.0, ""});
    r.asternResistance = in.number("asternResistance", {0.5, 4.0, ""});
    source = readProvenance(in);
    in.rejectUnknownKeys();
    return r;
}

MmgWake readWake(const config::Node& node, Provenance& source) {
    config::Reader in(node);
    MmgWake w;
    w.C1 = in.number("C1", {0.0, 20.0, ""});
    w.C2port = in.number("C2port", {0.1, 3.0, ""});
    w.C2starboard = in.number("C2starboard", {0.1, 3.0, ""});
    source = readProvenance(in);
    in.rejectUnknownKeys();
    return w;
}

MmgRudder readRudder(const config::Node& node, Provenance& source) {
    config::Reader in(node);
    MmgRudder r;
    r.height_m = in.number("height_m", {0.05, 30.0, "m"});
    r.liftSlope = in.number("liftSlope", {0.5, 6.2, ""});
    r.tR = in.number("tR", {-0.5, 0.9, ""});
    r.aH = in.number("aH", {-0.2, 1.5, ""});
    r.xH = in.number("xH", {-1.0, 0.0, ""});
    r.lR = in.number("lR", {-2.0, 0.0, ""});
    r.gammaPort = in.number("gammaPort", {0.0, 1.5, ""});
    r.gammaStarboard = in.number("gammaStarboard", {0.0, 1.5, ""});
    r.epsilon = in.number("epsilon", {0.3, 3.0, ""});
    r.kappa = in.number("kappa", {0.0, 1.5, ""});
    source = readProvenance(in);
    in.rejectUnknownKeys();
    return r;
}

std::vector<AsternSideRow> readAstern(const config::Node& node, std::optional<Provenance>& source) {
    config::Reader in(node);
    std::vector<AsternSideRow> rows;
    for (const config::Node& each : in.list("rows")) {
        const std::vector<double> v = each.numbers(3, {-10.0, 10.0, ""});
        if (v.empty()) continue;
        if (!rows.empty() && v[0] <= rows.back().J)
            each.problem("has J " + config::formatNumber(v[0]),
                         "more than the row before, " + config::formatNumber(rows.back().J));
        rows.push_back({v[0], v[1], v[2]});
    }
    if (rows.empty() && in.sound()) in.problem("rows", "is empty", "at least one row [J, Y, N]");
    source = readProvenance(in);
    in.rejectUnknownKeys();
    return rows;
}

}  // namespace

MmgModel readMmg(config::Reader& in) {
    MmgModel m;
    MmgParameters& p = m.parameters;
    p.inertia = readInertia(in.child("inertia"), m.sources.inertia);
    p.hull = readHullDerivatives(in.child("hull"), m.sources.hull);
    p.range = readRange(in.child("range"), m.sources.range);
    p.wake = readWake(in.child("wake"), m.sources.wake);
    p.rudder = readRudder(in.child("rudder"), m.sources.rudder);
    if (in.has("astern")) m.astern = readAstern(in.child("astern"), m.sources.astern);
    return m;
}

}  // namespace sagara::core
