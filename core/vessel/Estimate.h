#pragma once

#include <vector>

#include "core/vessel/Holtrop.h"
#include "core/vessel/MmgModel.h"
#include "core/vessel/Particulars.h"
#include "core/vessel/WageningenB.h"

/// The steps from particulars to a vessel document: what each group is estimated by. Used by
/// Particulars.cpp and its tests.
namespace sagara::core::estimate {

inline constexpr double kWater_kgpm3 = 1025.0;

/// Form and stability.
struct Form {
    double length_m, lengthOverall_m, beam_m, draught_m, volume_m3, block;
    double depth_m;
    double freeboard_m;
    double waterplane;       ///< Cwp = (1 + 2 Cb) / 3, Schneekluth and Bertram (1998), at least the kind's
    double metacentric_m;    ///< GM: KB by Morrish, BM = (0.1216 Cwp - 0.0410) B^2 / (T Cb), KG by kind
    double gravityHeight_m;  ///< KG
    double rollGyradius_m;   ///< dry: IMO 2008 IS Code roll period, a sixth of the inertia being added water
    double houseHeight_m;    ///< of the superstructure above the main deck
    double skeg_m2;          ///< lateral area of skeg, deadwood and brackets aft
    double mass_kg() const { return kWater_kgpm3 * volume_m3; }
};
Form formOf(const Particulars& p, const ShipKind& kind);

/// Propeller, resistance and shaft speed that belong together: a B4 propeller of the best pitch takes 85 % of
/// the power at the service speed and balances the resistance: that which the power tells, or that of Holtrop
/// and Mennen where no power is given.
struct Drive {
    double diameter_m, wake, deduction;
    BScrew screw;
    double shaft_rps, advance;  ///< J at the service speed
    double thrustEach_N;
    double resistance_N;
    double power_W;            ///< of all engines, maximum continuous
    bool powerKnown;           ///< and not worked out of the resistance
    double addedRace() const;  ///< 2 T / (rho disc) over the square of the ship's speed
    double speed_mps;
};
Drive driveOf(const Particulars& p, const ShipKind& kind, const Form& form);
/// The power, of all engines, maximum continuous, that overcomes a resistance at the service speed so.
double powerFor_W(double resistance_N, const Particulars& p, const ShipKind& kind, const Form& form);
/// The hull for a resistance by `holtropResistance`: midship section by Kerlen (1970), usual bulb and
/// appendages.
HoltropHull holtropHullOf(const Particulars& p, const ShipKind& kind, const Form& form);
/// Centre of buoyancy forward of midship, usual for the Froude number: Guldhammer and Harvald (1974).
double buoyancyForward_m(const Form& form, double speed_mps);
/// ITTC 1957 line over the wetted surface of Denny and Mumford.
double frictionalResistance_N(const Form& form, double speed_mps);
inline constexpr double kViscosity_m2ps = 1.19e-6;

/// Share of the maximum continuous power that the service speed takes.
inline constexpr double kServiceLoad = 0.85;

/// Height over chord of an estimated rudder.
inline constexpr double kRudderAspect = 1.8;

/// Rudders: area by the DNV rule or as usual for the kind, lift by Fujii, wake and race by the MMG model at
/// the service speed.
struct Rudders {
    double areaEach_m2;
    double liftSlope_perRad;  ///< of free flow at the ship's speed, wake and hull taken in
    double raceShare;
    std::vector<double> across_m;  ///< y of each
};
Rudders ruddersOf(const Particulars& p, const ShipKind& kind, const Form& form, const Drive& drive,
                  const std::vector<double>& shafts_m);
/// y of each shaft, port to starboard.
std::vector<double> shaftsAcross_m(int count, double beam_m);

/// Hull derivatives of Clarke, Gedling and Hine (1983), SI, speed taken out: Y_v v u and so on.
struct Derivatives {
    double Xudot, Yvdot, Nrdot;
    double Yv, Yr, Nv, Nr;
    double crossFlowDrag;  ///< Kijima et al. (1990): 2.5 T (1 - Cb) / B + 0.5
};
Derivatives derivativesOf(const Form& form);

/// Quadratic and higher derivatives of Kijima, Katsuno, Nakiri and Furukawa (1990), J. SNAJ 168, in lateral
/// velocity; other members 0.
MmgHull kijimaNonlinear(double length_m, double beam_m, double draught_m, double block);
/// What the stern of a full ship lifts less, in sideways flow, than the ships of Clarke's regression: over
/// 1/2 rho L d, as of a fin at the stern taken away. Without it full forms are too steady on their course.
/// Chosen on three tankers (Sagara, 2026): zigzags of KVLCC2 as measured at MARIN and HSVA, of Esso Osaka and
/// of the 190 000 t tanker of Van Berlekom and Goddard (1972).
double sternLoss(const Form& form);
/// The whole MMG model: linear derivatives of Clarke et al. with the skeg as a fin aft and less the loss of
/// full sterns, the rest of Kijima et al. with more of Nvvr; X of Yoshimura and Masumoto (2012); rudder of
/// these, Kijima and Quadvlieg (2013).
MmgParameters mmgOf(const Form& form, const Drive& drive, const Rudders& rudders);
/// Side force of a single screw astern: that of the 3 m Esso Osaka (Hachii, in Miyauchi et al. 2022) for the
/// same thrust.
std::vector<AsternSideRow> asternOf(const Form& form, const Drive& drive);

}  // namespace sagara::core::estimate
