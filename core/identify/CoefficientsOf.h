#pragma once

#include "core/identify/Coefficient.h"

namespace sagara::core {

std::vector<Coefficient> mmgCoefficients(const MmgModel& model, const std::set<std::string>& wanted);
std::vector<Coefficient> polynomialCoefficients(const NamedModel& model, const std::set<std::string>& wanted);
std::vector<Coefficient> transferCoefficients(const NamedModel& model, const std::set<std::string>& wanted);

}  // namespace sagara::core
