#pragma once

#include <vector>

#include "core/seakeeping/SeakeepingTables.h"
#include "core/seakeeping/Strips.h"

/// Strip theory of Salvesen, Tuck and Faltinsen (1970, SNAME 78, 250-287): slender hull, small motions, deep
/// water, waves not much shorter than the beam. What goes in and comes out is about Bo in frame B, as in
/// `SeakeepingTables`. Surge is outside the theory: added mass after Soeding (1982), no damping, and the
/// pressure gradient of the wave along the hull.
namespace sagara::core {

/// The hull as strip theory wants it.
struct StripHull {
    std::vector<Strip> strips;
    std::vector<double> x_m;  ///< of the strips
    double waterDensity_kgpm3 = 0.0;
    double surgeAddedMass_kg = 0.0;
    double buoyancyDepth_m = 0.0;
    double volume_m3 = 0.0;
};
StripHull stripHullOf(const HullForm& form, std::vector<std::string>* notes = nullptr);

/// Radiated waves of every strip at one frequency of encounter > 0.
struct HullFlow {
    double omega_radps = 0.0;
    std::vector<SectionFlow> strips;
};
HullFlow flowAbout(const StripHull& hull, double omega_radps);
/// Between two neighbours; `share` of the way from the first to the second.
HullFlow between(const HullFlow& low, const HullFlow& high, double share);

Radiation radiationOf(const StripHull& hull, const HullFlow& flow);
/// Without the end terms, which have no part at infinite frequency.
Matrix6 addedMassAtInfinity(const StripHull& hull);

/// A regular wave as a ship meets it.
struct MetWave {
    double omega_radps = 0.0;          ///< of the wave
    double relativeHeading_rad = 0.0;  ///< heading minus the direction the waves travel to
    double speed_mps = 0.0;

    double waveNumber_radpm() const;
    double encounter_radps() const;  ///< below nothing where the ship overtakes the waves
};

Complex6 froudeKrylovForce(const StripHull& hull, const MetWave& wave);
/// `flow` at |encounter frequency| of the wave. With the end terms of the aftmost section if wanted.
Complex6 diffractionForce(const StripHull& hull, const HullFlow& flow, const MetWave& wave,
                          bool transomTerms);

/// Rigid body and hydrostatic stiffness about Bo.
Matrix6 massMatrix(const HullForm& form);
Matrix6 restoringMatrix(const HullForm& form);

}  // namespace sagara::core
