#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Config.h"

/// A published set of hull derivatives (Abkowitz type) as data. The physics is in core/motion.
namespace sagara::core {

/// One row of a published polynomial: a product of at most six quantities and its coefficient in each force.
struct PolynomialTerm {
    /// Quantities a factor can name, in the units of the set. `absolute` makes their absolute values.
    enum class Factor : std::uint8_t {
        One,
        Surge,  ///< its perturbation where the set says so
        Sway,
        YawRate,
        RollRate,
        Roll,
        Rudder,    ///< with the sign of the set
        Inflow,    ///< c, flow speed at the rudder by the set's own rule
        Shaft,     ///< n, mean of the shafts
        Sideslip,  ///< atan(v/u)
        Depth,     ///< z = T / (h - T)
        Count
    };
    static constexpr std::size_t kFactors = 6;
    std::array<Factor, kFactors> factors{};
    double surge = 0.0;        ///< X
    double sway = 0.0;         ///< Y
    double roll = 0.0;         ///< K
    double yaw = 0.0;          ///< N
    bool crossFlow = false;    ///< fades out below the published range, where cross-flow drag takes over
    bool turnsAstern = false;  ///< changes sign with the direction of motion (an even |u| that stands for u)
    double fromDepth = 0.0;    ///< the row holds from this depth parameter on

    bool has(Factor factor) const;  ///< or its absolute value
};
constexpr PolynomialTerm::Factor absolute(PolynomialTerm::Factor factor) {
    return static_cast<PolynomialTerm::Factor>(static_cast<std::uint8_t>(factor) +
                                               static_cast<std::uint8_t>(PolynomialTerm::Factor::Count));
}

/// "phi |u| v", "r^2", "1": factors separated by spaces; false when it is not that or has more than six.
bool parseFactors(const std::string& text,
                  std::array<PolynomialTerm::Factor, PolynomialTerm::kFactors>& factors);

/// How numbers of the set become SI.
struct PolynomialScale {
    enum class By {
        Si,
        Prime,           ///< 1/2 rho, L and the instantaneous speed through the water
        PrimeReference,  ///< 1/2 rho, L and the reference speed
        Bis              ///< ship's mass, L and g (Norrbin)
    };
    By by = By::Si;
    double length_m = 1.0;
    double referenceSpeed_mps = 0.0;
    bool perturbation = false;  ///< u is the surge speed less the reference speed
    double rudderSign = 1.0;    ///< of the set's rudder angle when the bow is turned to starboard
};

/// Rudder and thrust of the 51.5 m patrol vessel's set, with the extension that lets the ship start, stop,
/// back and turn on the spot: see PolynomialShip.
struct LiftDrive {
    double rudderYawLever_m = 0.0;   ///< moment of the rudder force about Bo, abaft midship
    double rudderRollLever_m = 0.0;  ///< of the inward heel
    /// Published thrust: independent of speed, this much in all at this shaft speed, with its square at
    /// others.
    double thrust_N = 0.0;
    double shaft_rps = 1.0;
    double holdsFrom_mps = 0.0;  ///< published range of speed ahead
    double holdsTo_mps = 0.0;
    double extensionBelow_mps =
        0.0;  ///< the low-speed extension is whole below this speed, nothing from holdsFrom on
    double crossFlowDrag = 0.0;  ///< coefficient at rest
};

/// Propeller and rudder in its race as Son and Nomoto (1981) published them with their set; symbols theirs,
/// lengths over L unless they say metres.
struct RaceDrive {
    double diameter_m = 0.0;
    std::array<double, 3> thrustCoefficients{};  ///< KT = c0 + c1 J + c2 J^2
    double t = 0.0, wp = 0.0;                    ///< thrust deduction; wake fraction straight ahead
    double tau = 0.0, xp = 0.0, cpv = 0.0, cpr = 0.0;
    double area_m2 = 0.0, aspect = 0.0;
    double eps = 0.0, kk = 0.0;
    double ga = 0.0, cRr = 0.0, cRrrr = 0.0, cRrrv = 0.0;
    double cRX = 0.0, aH = 0.0, xR = 0.0, xH = 0.0, zR = 0.0;
};

/// For sets that hold thrust and resistance in balance at one shaft speed and say nothing of others: the
/// thrust of the vessel's propellers at the shaft speed there is, less that at this one, is added.
struct BalancedDrive {
    double shaft_rps = 1.0;
};

/// A published set in 3 or 4 degrees of freedom, with the rigid body and added mass it goes with and what it
/// says of rudder and propeller. Numbers in the units of `scale`.
struct PolynomialModel {
    PolynomialScale scale;
    double mass = 0.0;
    double xG = 0.0;
    double zG = 0.0;
    std::optional<double> Ixx;  ///< none: the set has no roll
    double Izz = 0.0;
    /// Added mass with the sign of the derivative (Xudot is negative).
    double Xudot = 0.0, Yvdot = 0.0, Ypdot = 0.0, Yrdot = 0.0;
    double Kvdot = 0.0, Kpdot = 0.0, Krdot = 0.0;
    double Nvdot = 0.0, Npdot = 0.0, Nrdot = 0.0;
    /// What is added to these per unit of the depth parameter.
    double XudotDepth = 0.0, YvdotDepth = 0.0, NrdotDepth = 0.0;
    bool turningInTerms = false;   ///< the rows hold what comes of the turning of frame B, such as m u r
    double draught_m = 0.0;        ///< T of the depth parameter; 0: the set knows no depth
    double leastDepthRatio = 1.2;  ///< h/T below which the depth parameter is held
    double inflow_m = 0.0, inflow_m2 = 0.0;  ///< c^2 = inflow_m u n + inflow_m2 n^2
    std::vector<PolynomialTerm> terms;
    std::optional<LiftDrive> lift;
    std::optional<RaceDrive> race;
    std::optional<BalancedDrive> balanced;
};
PolynomialModel readPolynomial(config::Reader& in);

}  // namespace sagara::core
