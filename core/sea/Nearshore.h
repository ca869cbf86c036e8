#pragma once

/// What becomes of waves on their way to the shore, where the depth is no longer that of the open area.
namespace sagara::core {

/// Height over what it was at `fromDepth_m`: sqrt(cg(from)/cg(here)), energy flux kept, refraction left out
/// (linear theory; Dean and Dalrymple 1991, section 4.7).
double shoalingCoefficient(double period_s, double fromDepth_m, double depth_m);

/// Largest significant height the depth carries: 0.88/k tanh(0.6 k h/0.88), the form of Battjes and Janssen
/// (1978): 0.6 h on a beach (measured 0.4 to 0.8, Thornton and Guza 1982), 0.14 of the length in deep water.
double breakingHeight_m(double period_s, double depth_m);

}  // namespace sagara::core
