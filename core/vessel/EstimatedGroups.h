#pragma once

#include <nlohmann/json.hpp>

#include "core/vessel/Estimate.h"

namespace sagara::core::estimate {

/// The vessel document put together, every group with its source. Numbers are rounded to four figures.
nlohmann::ordered_json documentOf(const Particulars& p, const ShipKind& kind, const Form& form,
                                  const Drive& drive);

nlohmann::ordered_json modelGroup(const Form& form, const Drive& drive, const Rudders& rudders, int shafts);
nlohmann::ordered_json mooringGroup(const Form& form, double equipmentNumber);
nlohmann::ordered_json groundTackleGroup(const Form& form, double equipmentNumber);

/// IACS UR A1: displacement^(2/3) + 2 h B + A / 10.
double equipmentNumber(const Form& form, double lateralArea_m2);
/// To four significant figures.
double neat(double value);

}  // namespace sagara::core::estimate
