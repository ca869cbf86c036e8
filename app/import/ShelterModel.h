#pragma once

#include <vector>

#include "app/import/CoastSource.h"
#include "app/import/ImportDescription.h"
#include "app/import/Raster.h"

namespace sagara::importer {

/// Factor on wave height, 0 to 1, at every node of every raster (finest first, each inside the next): the
/// root of the share of the energy offshore that arrives.
///
/// Every direction of the sectors is a straight-crested wave that comes in over the sides of the outermost
/// raster. Where its front has to go a way round land that is longer by D than the straight one, 1 / (1 + 8
/// pi^2 D / L) of its energy arrives, L the wave length: behind one straight edge, at r from it and turned by
/// a, D = r (1 - cos a), and this runs into the incident term of Penney & Price (1952, Phil. Trans. A 244,
/// 236-253; Sommerfeld's half plane) deep in the shadow; in the open it is 1. Several edges count as one with
/// the same detour (Maekawa 1968, Applied Acoustics 1, 157-173), which lets a little too much through.
///
/// Not in it: refraction and shoaling, breaking, reflection, harbour resonance, waves made inside, the spread
/// of wave lengths. One factor serves all waves, so wind sea from a direction outside the sectors is
/// sheltered as these are.
std::vector<std::vector<double>> modelShelter(const ShelterRules& rules, const std::vector<Raster>& rasters,
                                              const LocalCoast& coast);

/// Share of the energy that arrives by a way so much longer than the straight one.
double arrivingEnergy(double detour_m, double waveLength_m);

}  // namespace sagara::importer
