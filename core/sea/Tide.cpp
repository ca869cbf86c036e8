#include "core/sea/Tide.h"

#include <array>
#include <cassert>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Trig.h"

namespace sagara::core {
namespace {

/// Mean longitudes in degrees: hour angle of the mean sun, moon, sun, lunar perigee, lunar node, solar
/// perigee.
struct Astronomy {
    double T, s, h, p, N, p1;
};

Astronomy astronomy(Utc instant) {
    const double days = daysSinceJ2000(instant);
    const double c = days / 36525.0;
    const double dayFraction = std::fmod(days + 0.5, 1.0);
    return {.T = 180.0 + 360.0 * dayFraction,
            .s = 218.3164477 + 481267.88123421 * c,
            .h = 280.46646 + 36000.76983 * c,
            .p = 83.3532465 + 4069.0137287 * c,
            .N = 125.04452 - 1934.136261 * c,
            .p1 = 282.93735 + 1.71946 * c};
}

/// Whose node factor a constituent takes, and to which power.
enum class Node { None, M2, K2, O1, K1, J1, OO1, Mf, Mm };

struct Argument {
    std::string_view name;
    int T, s, h, p, p1;
    double offset_deg;
    Node node;
    double power;
};

// Schureman (1958), table 2; compounds from their parts.
constexpr std::array<Argument, 42> kArguments{{
    {"SA", 0, 0, 1, 0, 0, 0, Node::None, 1},       {"SSA", 0, 0, 2, 0, 0, 0, Node::None, 1},
    {"MM", 0, 1, 0, -1, 0, 0, Node::Mm, 1},        {"MSF", 0, 2, -2, 0, 0, 0, Node::M2, 1},
    {"MF", 0, 2, 0, 0, 0, 0, Node::Mf, 1},         {"MTM", 0, 3, 0, -1, 0, 0, Node::Mf, 1},
    {"2Q1", 1, -4, 1, 2, 0, 90, Node::O1, 1},      {"Q1", 1, -3, 1, 1, 0, 90, Node::O1, 1},
    {"RHO1", 1, -3, 3, -1, 0, 90, Node::O1, 1},    {"O1", 1, -2, 1, 0, 0, 90, Node::O1, 1},
    {"P1", 1, 0, -1, 0, 0, 90, Node::None, 1},     {"S1", 1, 0, 0, 0, 0, 0, Node::None, 1},
    {"K1", 1, 0, 1, 0, 0, -90, Node::K1, 1},       {"J1", 1, 1, 1, -1, 0, -90, Node::J1, 1},
    {"OO1", 1, 2, 1, 0, 0, -90, Node::OO1, 1},     {"SGM", 1, -4, 3, 0, 0, 90, Node::O1, 1},
    {"3N2", 2, -5, 2, 3, 0, 0, Node::M2, 1},       {"EP2", 2, -5, 4, 1, 0, 0, Node::M2, 1},
    {"2N2", 2, -4, 2, 2, 0, 0, Node::M2, 1},       {"MU2", 2, -4, 4, 0, 0, 0, Node::M2, 1},
    {"N2", 2, -3, 2, 1, 0, 0, Node::M2, 1},        {"NU2", 2, -3, 4, -1, 0, 0, Node::M2, 1},
    {"M2", 2, -2, 2, 0, 0, 0, Node::M2, 1},        {"MKS2", 2, -2, 4, 0, 0, 0, Node::K2, 1},
    {"LAMBDA2", 2, -1, 0, 1, 0, 180, Node::M2, 1}, {"L2", 2, -1, 2, -1, 0, 180, Node::M2, 1},
    {"T2", 2, 0, -1, 0, 1, 0, Node::None, 1},      {"S2", 2, 0, 0, 0, 0, 0, Node::None, 1},
    {"R2", 2, 0, 1, 0, -1, 180, Node::None, 1},    {"K2", 2, 0, 2, 0, 0, 0, Node::K2, 1},
    {"2SM2", 2, 2, -2, 0, 0, 0, Node::M2, -1},     {"M3", 3, -3, 3, 0, 0, 0, Node::M2, 1.5},
    {"S3", 3, 0, 0, 0, 0, 0, Node::None, 1},       {"N4", 4, -6, 4, 2, 0, 0, Node::M2, 2},
    {"MN4", 4, -5, 4, 1, 0, 0, Node::M2, 2},       {"M4", 4, -4, 4, 0, 0, 0, Node::M2, 2},
    {"MS4", 4, -2, 2, 0, 0, 0, Node::M2, 1},       {"S4", 4, 0, 0, 0, 0, 0, Node::None, 1},
    {"M6", 6, -6, 6, 0, 0, 0, Node::M2, 3},        {"2MS6", 6, -4, 4, 0, 0, 0, Node::M2, 2},
    {"M8", 8, -8, 8, 0, 0, 0, Node::M2, 4},        {"MSQM", 0, 4, -2, 0, 0, 0, Node::Mf, 1},
}};

// Mean motions in degrees per hour: Schureman (1958), table 1.
constexpr double kRateT = 15.0, kRateS = 0.54901653, kRateH = 0.04106864, kRateP = 0.00464183,
                 kRateP1 = 0.00000196;

struct NodeFactor {
    double f;
    double u_deg;
};

/// Pugh (1987), table 4:3. N in radians.
NodeFactor nodeFactor(Node node, double N) {
    const double c1 = std::cos(N), c2 = std::cos(2 * N), s1 = std::sin(N), s2 = std::sin(2 * N);
    switch (node) {
        case Node::None:
            return {1.0, 0.0};
        case Node::M2:
            return {1.000 - 0.037 * c1, -2.1 * s1};
        case Node::K2:
            return {1.024 + 0.286 * c1 + 0.008 * c2, -17.7 * s1 + 0.7 * s2};
        case Node::O1:
            return {1.009 + 0.187 * c1 - 0.015 * c2, 10.8 * s1 - 1.3 * s2};
        case Node::K1:
            return {1.006 + 0.115 * c1 - 0.009 * c2, -8.9 * s1 + 0.7 * s2};
        case Node::J1:
            return {1.013 + 0.168 * c1, -12.9 * s1 + 1.3 * s2};
        case Node::OO1:
            return {1.105 + 0.650 * c1, -36.7 * s1 + 4.0 * s2};
        case Node::Mf:
            return {1.043 + 0.414 * c1, -23.7 * s1 + 2.7 * s2};
        case Node::Mm:
            return {1.000 - 0.130 * c1, 0.0};
    }
    return {1.0, 0.0};
}

const Argument* findArgument(std::string_view name) {
    for (const Argument& a : kArguments) {
        if (a.name == name) return &a;
    }
    return nullptr;
}

}  // namespace

bool isTidalConstituent(std::string_view name) { return findArgument(name) != nullptr; }

std::string tidalConstituentNames() {
    std::string all;
    for (const Argument& a : kArguments) all += (all.empty() ? "" : ", ") + std::string(a.name);
    return all;
}

TidePrediction::TidePrediction(double meanAboveDatum_m, const std::vector<TidalConstituent>& constituents,
                               Utc start)
    : m_mean_m(meanAboveDatum_m) {
    const Astronomy sky = astronomy(start);
    for (const TidalConstituent& constituent : constituents) {
        const Argument* a = findArgument(constituent.name);
        assert(a && "the area loader refuses unknown constituents");
        const NodeFactor node = nodeFactor(a->node, sky.N * kDegree_rad);
        const double equilibrium_deg =
            a->T * sky.T + a->s * sky.s + a->h * sky.h + a->p * sky.p + a->p1 * sky.p1 + a->offset_deg;
        const double rate_degph =
            a->T * kRateT + a->s * kRateS + a->h * kRateH + a->p * kRateP + a->p1 * kRateP1;
        m_terms.push_back(
            {constituent.amplitude_m * std::pow(node.f, a->power), rate_degph * kDegree_rad / 3600.0,
             wrapTwoPi((equilibrium_deg + a->power * node.u_deg) * kDegree_rad - constituent.phaseLag_rad)});
    }
}

double TidePrediction::height_m(SimTime time) const {
    double height_m = m_mean_m;
    for (const Term& term : m_terms) {
        height_m += term.amplitude_m * sinCos(term.speed_radps * time.seconds() + term.phase_rad).cos;
    }
    return height_m;
}

}  // namespace sagara::core
