#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/vessel/Vessel.h"

namespace sagara::core {

/// One number of a vessel's manoeuvring model that trials may tell.
struct Coefficient {
    std::string name;   ///< for people: "hull.Yv", "terms[3] |u| v: N"
    std::string group;  ///< its group's place in the document, from the model: "/hull"; empty: the model
    std::string key;    ///< its place in the group: "/Yv", "/terms/3/N"
    std::function<double&(NamedModel&)> in;
    double prior = 0.0;  ///< how far, in standard deviations, it is believed to be from its present value
    double low = 0.0;    ///< accepted by the document's reader
    double high = 0.0;
};

/// What may be fitted of a model. Of mmg: hull, wake, rudder; of the others: turning, resistance. A number
/// that is 0 in the document is no part of the model and stays so. `wanted`: empty for all.
std::vector<Coefficient> coefficientsOf(const NamedModel& model, const std::set<std::string>& wanted = {});
/// Names that `wanted` may have for this model.
std::set<std::string> coefficientGroupsOf(const NamedModel& model);

/// Shares of its value that a coefficient is believed to be right to, by the quality of its group: measured
/// and published 0.3, the scatter of captive tests between facilities and of ships of one type; others 0.5.
double priorShare(Quality quality);

}  // namespace sagara::core
