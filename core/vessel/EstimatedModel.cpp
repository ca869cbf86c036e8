#include <cmath>

#include "core/base/Config.h"
#include "core/base/Units.h"
#include "core/vessel/EstimatedGroups.h"

namespace sagara::core::estimate {
namespace {

using Json = nlohmann::ordered_json;

Json marked(Json group, const std::string& source) {
    group["source"] = source;
    group["quality"] = "estimated";
    return group;
}

Json inertiaGroup(const MmgInertia& i) {
    return marked(
        {{"xG_m", neat(i.xG_m)},
         {"yawGyradius_m", neat(i.yawGyradius_m)},
         {"mx", neat(i.mx)},
         {"my", neat(i.my)},
         {"Jz", neat(i.Jz)}},
        "centre of gravity over that of buoyancy usual for the Froude number (Guldhammer & Harvald "
        "1974); added masses: Soeding 1982 in surge, Zhou, Sheng & Wu 1983 after Motora in sway and yaw");
}

Json hullGroup(const MmgHull& h, const Form& f, bool powerKnown) {
    return marked(
        {{"R0", neat(h.R0)},
         {"Xvv", neat(h.Xvv)},
         {"Xvr", neat(h.Xvr)},
         {"Xrr", neat(h.Xrr)},
         {"Xvvvv", neat(h.Xvvvv)},
         {"Yv", neat(h.Yv)},
         {"Yr", neat(h.Yr)},
         {"Yvv", neat(h.Yvv)},
         {"Yrr", neat(h.Yrr)},
         {"Yvvr", neat(h.Yvvr)},
         {"Yvrr", neat(h.Yvrr)},
         {"Nv", neat(h.Nv)},
         {"Nr", neat(h.Nr)},
         {"Nvv", neat(h.Nvv)},
         {"Nrrr", neat(h.Nrrr)},
         {"Nvvr", neat(h.Nvvr)},
         {"Nvrr", neat(h.Nvrr)}},
        "linear derivatives: Clarke, Gedling & Hine 1983" +
            std::string(f.skeg_m2 > 0.0
                            ? ", to which " + config::formatNumber(neat(f.skeg_m2)) +
                                  " m2 of skeg and brackets at -0.45 Lpp are added (usual for the type, lift "
                                  "slope 1.8)"
                            : "") +
            (sternLoss(f) > 0.0
                 ? ", from which a fin of lift " + config::formatNumber(neat(sternLoss(f))) +
                       " at -0.5 Lpp is taken as of full sterns (chosen on three tankers, Sagara 2026)"
                 : "") +
            "; higher ones: Kijima, Katsuno, Nakiri & Furukawa 1990, but Nrrr and X of Yoshimura & Masumoto "
            "2012, and Nvvr less by 0.157, as KVLCC2 and KCS have it; resistance: " +
            std::string(powerKnown
                            ? "what the propeller overcomes at the service speed with 85 % of the power"
                            : "Holtrop & Mennen 1982 and Holtrop 1984 at the service speed") +
            "; good to 20 to 30 % in turning");
}

Json rangeGroup(const MmgRange& r) {
    return marked(
        {{"drift_deg", neat(r.drift_rad / kDegree_rad)},
         {"yawRate", neat(r.yawRate)},
         {"crossFlowDrag", neat(r.crossFlowDrag)},
         {"asternResistance", neat(r.asternResistance)}},
        "the regressions serve hard-over turns; beyond, the cross-flow drag of Kijima et al. 1990 in "
        "pure drift, 2.5 T (1 - Cb) / B + 0.5");
}

Json wakeGroup(const MmgWake& w) {
    return marked({{"C1", neat(w.C1)}, {"C2port", neat(w.C2port)}, {"C2starboard", neat(w.C2starboard)}},
                  "as of KVLCC2, mean of both sides (Yasukawa & Yoshimura 2015)");
}

Json rudderGroup(const MmgRudder& r) {
    return marked(
        {{"height_m", neat(r.height_m)},
         {"liftSlope", neat(r.liftSlope)},
         {"tR", neat(r.tR)},
         {"aH", neat(r.aH)},
         {"xH", neat(r.xH)},
         {"lR", neat(r.lR)},
         {"gammaPort", neat(r.gammaPort)},
         {"gammaStarboard", neat(r.gammaStarboard)},
         {"epsilon", neat(r.epsilon)},
         {"kappa", neat(r.kappa)}},
        "lift: Fujii for an aspect ratio of 1.8; tR: Yoshimura & Masumoto 2012; aH: Quadvlieg 2013; kappa: "
        "Kijima et al. 1990; straightening, lR and epsilon between the published KVLCC2, Esso Osaka "
        "and KCS");
}

Json asternGroup(const std::vector<AsternSideRow>& rows) {
    Json table = Json::array();
    for (const AsternSideRow& row : rows) table.push_back({neat(row.J), neat(row.Y), neat(row.N)});
    return marked(
        {{"rows", std::move(table)}},
        "side force of a right-handed screw astern as of Esso Osaka for the same thrust (3 m model, "
        "Hachii in Miyauchi et al. 2022)");
}

}  // namespace

Json modelGroup(const Form& f, const Drive& drive, const Rudders& rudders, int shafts) {
    const MmgParameters p = mmgOf(f, drive, rudders);
    Json model = marked({{"kind", "mmg"}},
                        "MMG standard method (Yasukawa & Yoshimura 2015) with every group from published "
                        "regressions on the main particulars");
    model["inertia"] = inertiaGroup(p.inertia);
    model["hull"] = hullGroup(p.hull, f, drive.powerKnown);
    model["range"] = rangeGroup(p.range);
    model["wake"] = wakeGroup(p.wake);
    model["rudder"] = rudderGroup(p.rudder);
    if (shafts == 1) model["astern"] = asternGroup(asternOf(f, drive));
    return model;
}

}  // namespace sagara::core::estimate
