#pragma once

#include "core/vessel/Hull.h"
#include "core/vessel/MmgModel.h"

namespace sagara::core {

/// What a depth multiplies deep-water values by; all 1 in deep water.
struct ShallowFactors {
    double Yv = 1.0, Nv = 1.0, Nr = 1.0;
    double Yr = 1.0;  ///< of Yr - (m + mx)
    double mx = 1.0, my = 1.0, Jz = 1.0;
    double resistance = 1.0;
    double inflow = 1.0;         ///< of 1 - w
    double push = 1.0;           ///< of 1 - t
    double straightening = 1.0;  ///< of gamma_R
};

/// Derivatives: Kijima and Nakiri (1990), "Prediction method of ship manoeuvrability in deep and shallow
/// waters", MARSIM & ICSM 90. Added masses: Sheng (1981), Li and Wu (1990). Propeller, rudder: Amin and
/// Hasegawa (2010), "Generalised mathematical model for ship manoeuvrability considering shallow water
/// effect". Resistance: Furukawa et al. (2016). Depth over draught 1.2 and more; held at 1.1 below.
ShallowFactors shallowFactors(const Hull& hull, double depth_m);

/// The parameters a ship has in water of this depth; exactly those given in deep water (infinite depth).
/// Terms of higher order in drift and cross flow follow the linear ones of their kind. Water carried along in
/// surge is held at half of the ship's mass, where the regression leaves the forms it was made for.
MmgParameters mmgInDepth(const MmgParameters& deep, const Hull& hull, double depth_m);

}  // namespace sagara::core
