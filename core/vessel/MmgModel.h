#pragma once

#include <optional>
#include <vector>

#include "core/vessel/Provenance.h"

/// Parameters of the MMG standard method, Yasukawa and Yoshimura (2015), J. Marine Science and Technology 20,
/// 37-52. Forces over 1/2 rho L d U^2, moments over 1/2 rho L^2 d U^2 (L between perpendiculars, d draught,
/// U speed of midship), lateral speed and yaw rate as v / U and r L / U, lengths over L. The physics is in
/// core/motion.
namespace sagara::core {

/// Mass distribution, and added masses over 1/2 rho L^2 d and 1/2 rho L^4 d.
struct MmgInertia {
    double xG_m = 0.0;           ///< centre of gravity forward of midship
    double yawGyradius_m = 1.0;  ///< about the centre of gravity
    double mx = 0.0, my = 0.0, Jz = 0.0;
};

/// Hull derivatives; those with phi are the roll coupling of the 4-DOF method (Yasukawa, Sakuno and Yoshimura
/// 2019).
struct MmgHull {
    double R0 = 0.0;
    double Xvv = 0.0, Xvr = 0.0, Xrr = 0.0, Xvvvv = 0.0, Xrphi = 0.0;
    double Yv = 0.0, Yr = 0.0, Yvvv = 0.0, Yvvr = 0.0, Yvrr = 0.0, Yrrr = 0.0;
    /// Of v|v| and r|r|, where a set has these in the place of the cubes (Kijima et al. 1990).
    double Yvv = 0.0, Yrr = 0.0, Nvv = 0.0, Nrr = 0.0;
    double Nv = 0.0, Nr = 0.0, Nvvv = 0.0, Nvvr = 0.0, Nvrr = 0.0, Nrrr = 0.0;
    double Yphi = 0.0, Yvvphi = 0.0, Yvrphi = 0.0, Yrrphi = 0.0;
    double Nphi = 0.0, Nvvphi = 0.0, Nvrphi = 0.0, Nrrphi = 0.0;
};

/// Where the derivatives hold, and the cross-flow drag that takes over at greater drift or swing.
struct MmgRange {
    double drift_rad = 0.0;      ///< derivatives hold to this drift angle; 0: nowhere
    double yawRate = 0.0;        ///< and to this r L / U
    double crossFlowDrag = 0.0;  ///< of the hull moved sideways
    /// What the cross flow of the swing counts for in side force and in moment (C_rY, C_rN of Yoshimura et
    /// al. 2009).
    double crossFlowSwayLever = 1.0, crossFlowYawLever = 1.0;
    double asternResistance = 1.0;  ///< over that ahead
};

/// Change of the wake with the drift angle at the propeller:
/// 1 - w = (1 - w0) (1 + (1 - exp(-C1 |beta_P|)) (C2 - 1)).
struct MmgWake {
    double C1 = 0.0;
    double C2port = 1.0;       ///< flow from the port bow, beta_P positive; with two screws: from outboard
    double C2starboard = 1.0;  ///< beta_P negative
    double inflow = 1.0;       ///< on 1 - w0, by the depth of the water: not in documents
    double push = 1.0;         ///< on 1 - t, the same
};

/// Rudders: where they are and how large is in the vessel's steering group.
struct MmgRudder {
    double height_m = 1.0;
    double liftSlope = 0.0;  ///< f_alpha: normal force over 1/2 rho A V^2 sin(alpha)
    double tR = 0.0;         ///< steering resistance deduction
    double aH = 0.0;         ///< share of the rudder force that acts on the hull besides
    double xH = 0.0;         ///< where, over L, forward of midship
    double lR = 0.0;         ///< effective position of the rudder in yaw, over L
    double gammaPort = 1.0;  ///< flow straightening, beta_R positive; with two rudders: from outboard
    double gammaStarboard = 1.0;
    double epsilon = 1.0;  ///< (1 - w) at the rudder over that at the propeller
    double kappa = 0.5;    ///< of the race's added velocity, what has built up at the rudder
};

/// What the wash of a single screw that drives astern does to the side of the stern, at one advance ratio:
/// J = u / (n D), negative with headway. Y over 1/2 rho L d (n D)^2, N over 1/2 rho L^2 d (n D)^2, as Hachii
/// measured them on Esso Osaka.
struct AsternSideRow {
    double J, Y, N;
};

/// All numbers together; cheap to copy.
struct MmgParameters {
    MmgInertia inertia;
    MmgHull hull;
    MmgRange range;
    MmgWake wake;
    MmgRudder rudder;
};

struct MmgModel {
    MmgParameters parameters;
    std::vector<AsternSideRow> astern;  ///< J rising, or none; beyond the ends as there
    /// Where each group comes from and how well it is known.
    struct Sources {
        Provenance inertia, hull, range, wake, rudder;
        std::optional<Provenance> astern;
    } sources;
};
MmgModel readMmg(config::Reader& in);

}  // namespace sagara::core
