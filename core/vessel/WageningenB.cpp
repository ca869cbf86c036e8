#include "core/vessel/WageningenB.h"

#include <algorithm>

namespace sagara::core {
namespace {

/// K = sum C J^s (P/D)^t (AE/A0)^u Z^v.
struct Term {
    double c;
    int s, t, u, v;
};

constexpr Term kThrust[] = {
    {0.00880496, 0, 0, 0, 0},   {-0.204554, 1, 0, 0, 0},    {0.166351, 0, 1, 0, 0},
    {0.158114, 0, 2, 0, 0},     {-0.147581, 2, 0, 1, 0},    {-0.481497, 1, 1, 1, 0},
    {0.415437, 0, 2, 1, 0},     {0.0144043, 0, 0, 0, 1},    {-0.0530054, 2, 0, 0, 1},
    {0.0143481, 0, 1, 0, 1},    {0.0606826, 1, 1, 0, 1},    {-0.0125894, 0, 0, 1, 1},
    {0.0109689, 1, 0, 1, 1},    {-0.133698, 0, 3, 0, 0},    {0.00638407, 0, 6, 0, 0},
    {-0.00132718, 2, 6, 0, 0},  {0.168496, 3, 0, 1, 0},     {-0.0507214, 0, 0, 2, 0},
    {0.0854559, 2, 0, 2, 0},    {-0.0504475, 3, 0, 2, 0},   {0.010465, 1, 6, 2, 0},
    {-0.00648272, 2, 6, 2, 0},  {-0.00841728, 0, 3, 0, 1},  {0.0168424, 1, 3, 0, 1},
    {-0.00102296, 3, 3, 0, 1},  {-0.0317791, 0, 3, 1, 1},   {0.018604, 1, 0, 2, 1},
    {-0.00410798, 0, 2, 2, 1},  {-0.000606848, 0, 0, 0, 2}, {-0.0049819, 1, 0, 0, 2},
    {0.0025983, 2, 0, 0, 2},    {-0.000560528, 3, 0, 0, 2}, {-0.00163652, 1, 2, 0, 2},
    {-0.000328787, 1, 6, 0, 2}, {0.000116502, 2, 6, 0, 2},  {0.000690904, 0, 0, 1, 2},
    {0.00421749, 0, 3, 1, 2},   {5.65229e-05, 3, 6, 1, 2},  {-0.00146564, 0, 3, 2, 2},
};

constexpr Term kTorque[] = {
    {0.00379368, 0, 0, 0, 0},  {0.00886523, 2, 0, 0, 0},   {-0.032241, 1, 1, 0, 0},
    {0.00344778, 0, 2, 0, 0},  {-0.0408811, 0, 1, 1, 0},   {-0.108009, 1, 1, 1, 0},
    {-0.0885381, 2, 1, 1, 0},  {0.188561, 0, 2, 1, 0},     {-0.00370871, 1, 0, 0, 1},
    {0.00513696, 0, 1, 0, 1},  {0.0209449, 1, 1, 0, 1},    {0.00474319, 2, 1, 0, 1},
    {-0.00723408, 2, 0, 1, 1}, {0.00438388, 1, 1, 1, 1},   {-0.0269403, 0, 2, 1, 1},
    {0.0558082, 3, 0, 1, 0},   {0.0161886, 0, 3, 1, 0},    {0.00318086, 1, 3, 1, 0},
    {0.015896, 0, 0, 2, 0},    {0.0471729, 1, 0, 2, 0},    {0.0196283, 3, 0, 2, 0},
    {-0.0502782, 0, 1, 2, 0},  {-0.030055, 3, 1, 2, 0},    {0.0417122, 2, 2, 2, 0},
    {-0.0397722, 0, 3, 2, 0},  {-0.00350024, 0, 6, 2, 0},  {-0.0106854, 3, 0, 0, 1},
    {0.00110903, 3, 3, 0, 1},  {-0.000313912, 0, 6, 0, 1}, {0.0035985, 3, 0, 1, 1},
    {-0.00142121, 0, 6, 1, 1}, {-0.00383637, 1, 0, 2, 1},  {0.0126803, 0, 2, 2, 1},
    {-0.00318278, 2, 3, 2, 1}, {0.00334268, 0, 6, 2, 1},   {-0.00183491, 1, 1, 0, 2},
    {0.000112451, 3, 2, 0, 2}, {-2.97228e-05, 3, 6, 0, 2}, {0.000269551, 1, 0, 1, 2},
    {0.00083265, 2, 0, 1, 2},  {0.00155334, 0, 2, 1, 2},   {0.000302683, 0, 6, 1, 2},
    {-0.0001843, 0, 0, 2, 2},  {-0.000425399, 0, 3, 2, 2}, {8.69243e-05, 3, 3, 2, 2},
    {-0.0004659, 0, 6, 2, 2},  {5.54194e-05, 1, 6, 2, 2},
};

double power(double base, int exponent) {
    double value = 1.0;
    for (int i = 0; i < exponent; ++i) value *= base;
    return value;
}

template <std::size_t n>
std::array<double, 4> polynomial(const Term (&terms)[n], const BScrew& screw) {
    std::array<double, 4> c{};
    for (const Term& term : terms)
        c[static_cast<std::size_t>(term.s)] += term.c * power(screw.pitchRatio, term.t) *
                                               power(screw.areaRatio, term.u) * power(screw.blades, term.v);
    return c;
}

template <std::size_t n>
double sum(const Term (&terms)[n], const BScrew& screw, double J) {
    double total = 0.0;
    for (const Term& term : terms) {
        total += term.c * power(J, term.s) * power(screw.pitchRatio, term.t) *
                 power(screw.areaRatio, term.u) * power(screw.blades, term.v);
    }
    return total;
}

}  // namespace

double BScrew::thrustCoefficient(double J) const { return sum(kThrust, *this, J); }
double BScrew::torqueCoefficient(double J) const { return sum(kTorque, *this, J); }
std::array<double, 4> BScrew::thrustPolynomial() const { return polynomial(kThrust, *this); }
std::array<double, 4> BScrew::torquePolynomial() const { return polynomial(kTorque, *this); }

}  // namespace sagara::core
