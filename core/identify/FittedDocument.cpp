#include "core/identify/FittedDocument.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

using Json = nlohmann::ordered_json;
using Place = Json::json_pointer;

/// Five figures.
double neat(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", value);
    return std::strtod(text, nullptr);
}

std::string figure(double value, int decimals, const char* unit) {
    char text[48];
    std::snprintf(text, sizeof text, "%.*f%s", decimals, value, unit);
    return text;
}

/// The model of that name in the document as it is written.
Json& modelIn(Json& document, std::string_view name) {
    if (!document.contains("models")) return document["model"];
    for (Json& model : document["models"])
        if (name.empty() || model.value("name", model.value("kind", "")) == name) return model;
    return document["models"].front();
}

void mark(Json& group, const std::string& how) {
    const std::string before = group.value("source", "");
    group["source"] = how + (before.empty() ? "" : "; before that: " + before);
    group["quality"] = "fitted";
}

std::string howFitted(const ManoeuvreFit& fit) {
    std::string how = "fitted by sagara-sim identify to";
    for (const FittedTrial& t : fit.trials) {
        how += (&t == fit.trials.data() ? " " : ", ") + t.name;
        std::string left;
        if (t.after.position_L) left += figure(*t.after.position_L, 3, " L");
        if (t.after.heading_rad)
            left += (left.empty() ? "" : ", ") + figure(*t.after.heading_rad / kDegree_rad, 2, " deg");
        if (!left.empty()) how += " (rms " + left + ")";
    }
    return how;
}

void writeManoeuvres(Json& vessel, Json& model, const ManoeuvreFit& fit) {
    std::set<Json*> touched;
    for (const FittedCoefficient& c : fit.coefficients) {
        Json& group = (c.coefficient.ofModel ? model : vessel)[Place(c.coefficient.group)];
        group[Place(c.coefficient.key)] = neat(c.after);
        if (touched.insert(&group).second) mark(group, howFitted(fit));
    }
    if (!touched.empty()) model["quality"] = "fitted";
}

void writeSwing(Json& seakeeping, const SwingFit& swing, const Hull& hull, std::string& how) {
    if (!swing.told()) return;
    const bool roll = swing.motion == Channel::Roll;
    const char* key = roll                             ? "rollDampingRatio"
                      : swing.motion == Channel::Pitch ? "pitchDampingRatio"
                                                       : "heaveDampingRatio";
    const double ratio = std::clamp(swing.equivalent(swing.amplitude), 0.005, 1.5);  // as the reader accepts
    seakeeping[key] = neat(ratio);
    how += (how.empty() ? "" : ", ") + std::string(key) + " fitted by sagara-sim identify";
    for (const std::string& trial : swing.trials)
        how += (&trial == swing.trials.data() ? " to " : ", ") + trial;
    if (!roll) return;
    how += ", as at " + figure(swing.amplitude / kDegree_rad, 1, " deg") + " of " +
           figure(swing.linear, 4, "") + " + " + figure(4.0 / (3.0 * kPi) * swing.quadratic, 4, "") +
           " per rad of amplitude";
    const double added =
        kGravity_mps2 * hull.metacentricHeight_m / std::pow(swing.frequency_radps * hull.rollGyradius_m, 2) -
        1.0;
    if (added < 0.0 || added > 5.0) return;
    seakeeping["rollAddedInertiaRatio"] = neat(added);
    how += ", added inertia by the period of " + figure(kTwoPi / swing.frequency_radps, 2, " s");
}

}  // namespace

std::string fittedDocument(std::string_view text, std::string_view model, const ManoeuvreFit& manoeuvres,
                           const std::vector<SwingFit>& swings) {
    Json document = Json::parse(text);
    writeManoeuvres(document, modelIn(document, model), manoeuvres);
    std::string how;
    for (const SwingFit& swing : swings)
        writeSwing(document["seakeeping"], swing, manoeuvres.vessel.hull, how);
    if (!how.empty()) mark(document["seakeeping"], how);
    return document.dump(2) + "\n";
}

}  // namespace sagara::core
