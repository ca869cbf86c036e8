#pragma once

#include <cmath>

namespace sagara::core {

/// Midship section coefficient of cargo ships by their block coefficient: Kerlen (1970), in Schneekluth and
/// Bertram (1998), Ship Design for Efficiency and Economy, section 1.5.
inline double kerlenMidshipCoefficient(double block) { return 1.006 - 0.0056 * std::pow(block, -3.56); }

}  // namespace sagara::core
