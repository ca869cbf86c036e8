#include "core/vessel/DeckGear.h"

#include <set>

#include "core/base/Units.h"
#include "core/vessel/ReadPoint.h"

namespace sagara::core {
namespace {

void checkUnique(std::set<std::string>& seen, config::Reader& in, const std::string& id) {
    if (!id.empty() && !seen.insert(id).second) in.problem("id", "is \"" + id + "\" again", "each id once");
}

}  // namespace

const Fairlead* MooringGear::find(const std::string& id) const {
    for (const Fairlead& f : fairleads) {
        if (f.id == id) return &f;
    }
    return nullptr;
}

MooringGear readMooringGear(config::Reader& in) {
    MooringGear gear;
    std::set<std::string> seen;
    for (const config::Node& node : in.list("fairleads")) {
        config::Reader fairlead(node);
        gear.fairleads.push_back({fairlead.text("id"), readBodyPoint(fairlead)});
        checkUnique(seen, fairlead, gear.fairleads.back().id);
        fairlead.rejectUnknownKeys();
    }
    gear.breakingLoad_N = 1000.0 * in.number("breakingLoad_kN", {5.0, 5000.0, "kN"});
    gear.stiffness_N = 1000.0 * in.number("stiffness_kN", {20.0, 1e6, "kN"});
    gear.winchPull_N = 1000.0 * in.number("winchPull_kN", {1.0, 2000.0, "kN"});
    gear.winchSpeed_mps = in.number("winchSpeed_mps", {0.02, 3.0, "m/s"});
    gear.provenance = readProvenance(in);
    in.rejectUnknownKeys();
    return gear;
}

GroundTackle readGroundTackle(config::Reader& in) {
    GroundTackle tackle;
    std::set<std::string> seen;
    for (const config::Node& node : in.list("anchors")) {
        config::Reader anchor(node);
        AnchorGear a;
        a.id = anchor.text("id");
        checkUnique(seen, anchor, a.id);
        a.hawse = readBodyPoint(anchor);
        a.hawseHeight_m = anchor.number("hawseHeight_m", {0.0, 40.0, "m"});
        a.anchorMass_kg = anchor.number("anchorMass_kg", {5.0, 50000.0, "kg"});
        a.holdingFactor = anchor.number("holdingFactor", {1.0, 40.0, ""});
        a.cableLength_m = kShackle_m * anchor.number("cable_shackles", {1.0, 20.0, "shackles"});
        a.cableMass_kgpm = anchor.number("cableMass_kgpm", {0.5, 500.0, "kg/m"});
        a.breakingLoad_N = 1000.0 * anchor.number("breakingLoad_kN", {10.0, 30000.0, "kN"});
        a.heaveSpeed_mps = anchor.number("heaveSpeed_mps", {0.02, 1.0, "m/s"});
        anchor.rejectUnknownKeys();
        tackle.anchors.push_back(a);
    }
    if (tackle.anchors.size() > kMostAnchors) {
        in.problem("anchors", "has " + std::to_string(tackle.anchors.size()),
                   "at most " + std::to_string(kMostAnchors));
    }
    tackle.provenance = readProvenance(in);
    in.rejectUnknownKeys();
    return tackle;
}

}  // namespace sagara::core
