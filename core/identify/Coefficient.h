#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/vessel/Vessel.h"

namespace sagara::core {

/// One number of a vessel's manoeuvring model that trials may tell.
struct Coefficient {
    std::string name;     ///< for people: "hull.Yv", "terms[3] |u| v: N"
    bool ofModel = true;  ///< false: of another group of the vessel
    std::string group;  ///< its group's place from the model or the vessel: "/hull"; empty: the model itself
    std::string key;    ///< its place in the group: "/Yv", "/terms/3/N"
    std::function<double&(Vessel&, NamedModel&)> in;  ///< the model is one of the vessel's
    double prior = 0.0;  ///< how far, in standard deviations, it is believed to be from its present value
    double low = 0.0;    ///< accepted by the document's reader
    double high = 0.0;
};

/// What may be fitted of a model. Of mmg: hull, wake, rudder; of polynomial: turning, resistance, roll; of
/// the others: turning, resistance. A number that is 0 in the document is no part of the model and stays so.
/// `wanted`: empty for all.
std::vector<Coefficient> coefficientsOf(const NamedModel& model, const std::set<std::string>& wanted = {});
/// Names that `wanted` may have for this model; "astern" is sternwardCoefficients.
std::set<std::string> coefficientGroupsOf(const NamedModel& model);

/// What a stop tells besides: thrust astern over that ahead of every propeller that has such a number.
std::vector<Coefficient> sternwardCoefficients(const Vessel& vessel);

/// Shares of its value that a coefficient is believed to be right to, by the quality of its group: measured
/// and published 0.3, the scatter of captive tests between facilities and of ships of one type; others 0.5.
double priorShare(Quality quality);

}  // namespace sagara::core
