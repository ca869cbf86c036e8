#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/vessel/Estimate.h"
#include "core/vessel/MidshipCoefficient.h"

namespace sagara::core::estimate {
namespace {

constexpr double kShaftEfficiency = 0.97;

/// Advance ratio at which KT / J^2 has this value: it falls without end as J grows.
double advanceFor(const BScrew& screw, double loading) {
    double low = 0.02, high = 1.6;
    for (int i = 0; i < 60; ++i) {
        const double J = 0.5 * (low + high);
        (screw.thrustCoefficient(J) > loading * J * J ? low : high) = J;
    }
    return 0.5 * (low + high);
}

/// Keller's area ratio for this thrust on two decks of static head.
double areaRatioFor(double thrust_N, double diameter_m, double draught_m, int shafts) {
    const double pressure_Pa =
        99047.0 + kWater_kgpm3 * kGravity_mps2 * std::max(0.5, draught_m - 0.5 * diameter_m);
    const double ratio =
        (1.3 + 0.3 * 4) * thrust_N / (pressure_Pa * diameter_m * diameter_m) + (shafts > 1 ? 0.1 : 0.2);
    return std::clamp(ratio, 0.40, 1.05);
}

/// The propeller of best efficiency for a resistance; the power it takes is told.
double propellerPower_W(Drive& d, const Particulars& p, const Form& form) {
    const double inflow_mps = (1.0 - d.wake) * p.speed_mps;
    d.thrustEach_N = d.resistance_N / ((1.0 - d.deduction) * p.shafts);
    const double loading =
        d.thrustEach_N / (kWater_kgpm3 * d.diameter_m * d.diameter_m * inflow_mps * inflow_mps);
    d.screw.areaRatio = areaRatioFor(d.thrustEach_N, d.diameter_m, form.draught_m, p.shafts);
    double best = -1.0, bestPitch = 0.5;
    for (int i = 0; i <= 18; ++i) {
        BScrew screw = d.screw;
        screw.pitchRatio = 0.5 + 0.05 * i;
        const double J = advanceFor(screw, loading);
        const double efficiency = J / kTwoPi * screw.thrustCoefficient(J) / screw.torqueCoefficient(J);
        if (efficiency > best) best = efficiency, bestPitch = screw.pitchRatio;
    }
    d.screw.pitchRatio = bestPitch;
    d.advance = advanceFor(d.screw, loading);
    d.shaft_rps = inflow_mps / (d.advance * d.diameter_m);
    return kTwoPi * d.screw.torqueCoefficient(d.advance) * kWater_kgpm3 * std::pow(d.shaft_rps, 3) *
           std::pow(d.diameter_m, 5) * p.shafts;
}

/// Speed, diameter, wake and thrust deduction; resistance and screw are still to be found.
Drive behindHull(const Particulars& p, const ShipKind& kind, const Form& form) {
    Drive d{};
    d.speed_mps = p.speed_mps;
    d.powerKnown = p.power_W.has_value();
    const bool single = p.shafts == 1;
    // Kristensen and Luetzen (2013); twin screws are a little smaller.
    const double usual_m = kind.fullForm ? 0.395 * form.draught_m + 1.30 : 0.623 * form.draught_m - 0.16;
    d.diameter_m = p.propellerDiameter_m.value_or(
        std::clamp(usual_m, 0.45 * form.draught_m, (single ? 0.75 : 0.70) * form.draught_m));
    // Taylor (1933); Schoenherr.
    d.wake = std::clamp(single ? 0.5 * form.block - 0.05 : 0.55 * form.block - 0.20, 0.02, 0.45);
    d.deduction = single ? 0.6 * d.wake : 0.25 * d.wake + 0.10;
    return d;
}

}  // namespace

double Drive::addedRace() const {
    const double disc_m2 = kPi / 4.0 * diameter_m * diameter_m;
    return 2.0 * thrustEach_N / (kWater_kgpm3 * disc_m2 * speed_mps * speed_mps);
}

HoltropHull holtropHullOf(const Particulars& p, const ShipKind& kind, const Form& f) {
    HoltropHull h{};
    h.length_m = std::clamp(1.02 * f.length_m, f.length_m, f.lengthOverall_m);
    h.beam_m = f.beam_m;
    h.draught_m = f.draught_m;
    h.volume_m3 = f.volume_m3;
    h.waterplane = f.waterplane;
    h.midship = kerlenMidshipCoefficient(std::max(f.block, 0.45));
    h.buoyancy_pct = 100.0 * buoyancyForward_m(f, p.speed_mps) / f.length_m;
    constexpr double kBulbFrom_m = 90.0;
    if (kind.bulb && f.length_m >= kBulbFrom_m) {
        h.bulb_m2 = 0.07 * f.beam_m * f.draught_m;
        h.bulbHeight_m = 0.4 * f.draught_m;
    }
    // Rudders, and with several screws their brackets and shafts, as shares of the wetted surface.
    h.appendages_m2 = (p.shafts == 1 ? 0.015 : 0.04) * f.length_m * (2.0 * f.draught_m + f.beam_m) * f.block;
    h.appendageForm = p.shafts == 1 ? 1.5 : 2.5;
    return h;
}

Drive driveOf(const Particulars& p, const ShipKind& kind, const Form& form) {
    Drive d = behindHull(p, kind, form);
    if (p.power_W) {
        const double delivered_W = kServiceLoad * kShaftEfficiency * *p.power_W;
        double low_N = 1.0, high_N = delivered_W / p.speed_mps * 1.5;
        for (int i = 0; i < 50; ++i) {
            d.resistance_N = 0.5 * (low_N + high_N);
            (propellerPower_W(d, p, form) < delivered_W ? low_N : high_N) = d.resistance_N;
        }
        d.power_W = *p.power_W;
    } else {
        d.resistance_N =
            holtropResistance(holtropHullOf(p, kind, form), p.speed_mps, kWater_kgpm3, kViscosity_m2ps)
                .total_N();
        d.power_W = propellerPower_W(d, p, form) / (kServiceLoad * kShaftEfficiency);
    }
    return d;
}

double powerFor_W(double resistance_N, const Particulars& p, const ShipKind& kind, const Form& form) {
    Drive d = behindHull(p, kind, form);
    d.resistance_N = resistance_N;
    return propellerPower_W(d, p, form) / (kServiceLoad * kShaftEfficiency);
}

std::vector<double> shaftsAcross_m(int count, double beam_m) {
    std::vector<double> across;
    const double spread_m = (count == 2 ? 0.50 : 0.60) * beam_m;
    for (int i = 0; i < count; ++i)
        across.push_back(count == 1 ? 0.0 : spread_m * (static_cast<double>(i) / (count - 1) - 0.5));
    return across;
}

Rudders ruddersOf(const Particulars& p, const ShipKind& kind, const Form& f, const Drive& drive,
                  const std::vector<double>& shafts_m) {
    Rudders r{};
    r.across_m = p.rudders == p.shafts ? shafts_m : shaftsAcross_m(p.rudders, f.beam_m);
    const bool inRace = std::any_of(r.across_m.begin(), r.across_m.end(), [&](double y) {
        return std::any_of(shafts_m.begin(), shafts_m.end(),
                           [&](double shaft) { return std::abs(shaft - y) < 0.5 * drive.diameter_m; });
    });
    const double slenderness = f.beam_m / f.length_m;
    double area_m2 = 0.01 * f.draught_m * f.length_m * (1.0 + 25.0 * slenderness * slenderness);
    area_m2 = std::max(area_m2, kind.rudderShare * f.length_m * f.draught_m);
    if (!inRace) area_m2 *= 1.3;  // DNV: where rudders do not work directly behind a propeller
    r.areaEach_m2 = p.rudderArea_m2.value_or(area_m2) / p.rudders;

    constexpr double kShare = 0.5;  // the race's part that has built up
    const double hullShare = 0.6784 - 1.3374 * f.block + 1.8891 * f.block * f.block;  // aH, Kijima (1990)
    const double fujii = 6.13 * kRudderAspect / (kRudderAspect + 2.25);
    const double wake = inRace ? drive.wake : 0.5 * drive.wake;
    r.liftSlope_perRad = fujii * (1.0 + hullShare) * (1.0 - wake) * (1.0 - wake);
    if (inRace) {
        const double covered = std::min(1.0, drive.diameter_m / std::sqrt(kRudderAspect * r.areaEach_m2));
        const double inflow2 = (1.0 - drive.wake) * (1.0 - drive.wake);
        const double s = std::sqrt(1.0 + drive.addedRace() / inflow2);
        const double built = 1.0 + kShare * (s - 1.0);
        const double share = covered * (built * built - 1.0) / (s * s - 1.0);
        constexpr double kHardOver = 0.7;  // a rudder hard over is partly out of the race
        r.raceShare = std::min(1.5, kHardOver * share / inflow2);
    }
    return r;
}

}  // namespace sagara::core::estimate
