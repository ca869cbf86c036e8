#include "core/vessel/CompleteVessel.h"

#include <array>
#include <nlohmann/json.hpp>

#include "core/base/Config.h"
#include "core/base/Units.h"
#include "core/vessel/Particulars.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {
namespace {

using Json = nlohmann::ordered_json;

/// Members whose unit in documents is that of pilot cards.
constexpr std::array<std::array<const char*, 2>, 3> kDocumentNames{
    {{"speed_mps", "speed_kn"}, {"power_W", "power_kW"}, {"bowThruster_W", "bowThruster_kW"}}};

std::string documentName(const std::string& member) {
    for (const auto& [ours, theirs] : kDocumentNames)
        if (member == ours) return theirs;
    return member;
}

/// Sizes are checked against each other by vesselFromParticulars; here only that they are numbers.
constexpr config::Range kAnyLength{0.0, 1000.0, "m"};

void readInto(Particulars& p, config::Reader& in) {
    const auto optional = [&](const char* key, config::Range range, double unit = 1.0) {
        const double value = in.numberOr(key, 0.0, range);
        return in.has(key) ? std::optional(unit * value) : std::nullopt;
    };
    p.kind = in.textOr("kind", p.kind);
    p.lengthOverall_m = in.number("lengthOverall_m", kAnyLength);
    p.lengthBp_m = in.number("lengthBp_m", kAnyLength);
    p.beam_m = in.number("beam_m", kAnyLength);
    p.draught_m = in.number("draught_m", kAnyLength);
    p.depth_m = optional("depth_m", kAnyLength);
    p.displacement_m3 = optional("displacement_m3", {0.0, 1e7, "m3"});
    p.blockCoefficient = optional("blockCoefficient", {0.0, 1.0});
    p.metacentricHeight_m = optional("metacentricHeight_m", kAnyLength);
    p.speed_mps = kKnot_mps * in.number("speed_kn", {4.0, 48.0, "kn"});
    p.power_W = optional("power_kW", {20.0, 120000.0, "kW"}, 1e3);
    p.shafts = in.integerOr("shafts", 1, 1, 4);
    p.rudders = in.integerOr("rudders", p.shafts, 1, 4);
    p.rudderArea_m2 = optional("rudderArea_m2", {0.0, 1000.0, "m2"});
    p.propellerDiameter_m = optional("propellerDiameter_m", {0.0, 12.0, "m"});
    p.bowThruster_W = optional("bowThruster_kW", {5.0, 5000.0, "kW"}, 1e3);
    p.source = in.textOr("source", "");
    in.rejectUnknownKeys();
}

/// `given` over what is estimated; what is estimated beside it keeps its place.
Json merged(Json estimated, const Json& given) {
    for (const auto& [key, group] : given.items()) {
        if (key == "particulars") continue;
        if (key == "models") estimated.erase("model");
        if (key == "hull" && group.is_object())
            estimated[key].update(group);
        else
            estimated[key] = group;
    }
    return estimated;
}

}  // namespace

Result<std::string, config::Problems> completeVessel(const std::string& name, std::string_view text) {
    config::Document document(name, text);
    config::Reader in(document.root());
    if (!document.wellFormed() || !in.has("particulars")) return std::string(text);
    if (!document.isKind("vessel", kVesselDocumentVersion)) return document.problems();
    Particulars p;
    p.id = in.id("id");
    p.name = in.text("name");
    p.kind = in.text("type");
    config::Reader group(in.child("particulars"));
    readInto(p, group);
    if (!in.sound()) return document.problems();
    const auto estimated = vesselFromParticulars(p);
    if (!estimated) {
        for (const config::Problem& problem : estimated.error().list()) {
            if (problem.path == "kind" && !group.has("kind"))
                in.problem("type", problem.found, problem.expected + "; or particulars.kind is that");
            else if (problem.path.find_first_of(".[") != std::string::npos)
                in.problem(problem.path, problem.found, problem.expected);  // of what is estimated
            else
                group.problem(documentName(problem.path), problem.found, problem.expected);
        }
        return document.problems();
    }
    return merged(Json::parse(*estimated), Json::parse(text)).dump(2) + "\n";
}

}  // namespace sagara::core
