#pragma once

#include "core/seakeeping/StripTheory.h"

namespace sagara::core {

/// Mean force of one wave on the hull below the waterline, in N and N m per square metre of amplitude, frame
/// B about Bo, the sum of two parts (as Fujii and Takahashi 1975, J. SNAJ 137, add them):
///
/// - of the waves the ship makes by heaving and pitching against the water: Gerritsma and Beukelman (1972),
///   Int. Shipbuilding Progress 19, 285-293, along the direction of the waves; abaft the beam with the wave's
///   own frequency in place of that of encounter, which their formula does not take there;
/// - of the waves her sides throw back: Faltinsen, Minsaas, Liapis and Skjoerdal (1980), 13th Symposium on
///   Naval Hydrodynamics, 505-529, for short waves on the waterline facing them, its term of forward speed
///   from ahead to the beam only, times the share of waves that the draught stops (Fujii and Takahashi).
///
/// `motion`: of Bo per metre of amplitude, crest at Bo at t = 0; in waves overtaken at the positive
/// frequency. `flow` at |encounter frequency|. What sway and roll radiate in waves of middle length from the
/// side is not in it.
MeanWaveForce meanWaveForce(const StripHull& hull, const HullFlow& flow, const MetWave& wave,
                            const Complex6& motion);

}  // namespace sagara::core
