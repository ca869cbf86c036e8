#include "core/world/Catenary.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {
namespace {

/// Distance spanned by a cable under the horizontal pull H; grows with H.
double span_m(double H, double height_m, double length_m, double w, double EA) {
    const double a = H / w;
    const double suspended_m = std::sqrt(height_m * (height_m + 2.0 * a));
    if (suspended_m <= length_m) {
        return length_m - suspended_m + a * std::asinh(suspended_m / a) + H * length_m / EA;
    }
    // None lies: the span follows from length and height alone, sqrt(s^2 - h^2) = 2 a sinh(x / 2a) (catenary
    // between two points).
    const double chord_m = std::sqrt(std::max(0.0, length_m * length_m - height_m * height_m));
    return 2.0 * a * std::asinh(chord_m / (2.0 * a)) + H * length_m / EA;
}

}  // namespace

CableShape cableShape(double horizontal_m, double height_m, double length_m, double weight_Npm,
                      double stiffness_N) {
    CableShape shape;
    const double hanging_m = std::min(height_m, length_m);
    if (length_m <= height_m || horizontal_m <= length_m - height_m) {
        shape.atHawse_N = weight_Npm * hanging_m;
        shape.lying_m = length_m - hanging_m;
        return shape;
    }
    double low_N = 0.0, high_N = weight_Npm * length_m;
    while (span_m(high_N, height_m, length_m, weight_Npm, stiffness_N) < horizontal_m && high_N < 1e10) {
        low_N = high_N;
        high_N *= 4.0;
    }
    for (int i = 0; i < 48; ++i) {
        const double middle_N = 0.5 * (low_N + high_N);
        (span_m(middle_N, height_m, length_m, weight_Npm, stiffness_N) < horizontal_m ? low_N : high_N) =
            middle_N;
    }
    const double H = 0.5 * (low_N + high_N), a = H / weight_Npm;
    const double suspended_m = std::sqrt(height_m * (height_m + 2.0 * a));
    shape.horizontal_N = H;
    if (suspended_m <= length_m) {
        shape.lying_m = length_m - suspended_m;
        shape.atHawse_N = H + weight_Npm * height_m;
        return shape;
    }
    // Vertical pulls at both ends differ by the weight of the cable; their sum is w h coth(x / 2a) (catenary
    // between two points).
    const double sum_N = weight_Npm * height_m / std::tanh(0.5 * horizontal_m / a);
    const double vertical_N = std::max(0.0, 0.5 * (sum_N - weight_Npm * length_m));
    shape.uplift_rad = std::atan2(vertical_N, H);
    shape.atHawse_N = std::hypot(H, vertical_N + weight_Npm * length_m);
    return shape;
}

}  // namespace sagara::core
