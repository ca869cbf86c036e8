#pragma once

#include "core/base/LocalFrame.h"
#include "core/base/Utc.h"

/// Where sun, moon and stars stand. Formulas: Meeus, Astronomical Algorithms (1998).
namespace sagara::render {

/// Direction in the sky: true bearing and height above the horizontal, refraction included where it says so.
struct Horizontal {
    double bearing_rad = 0.0;
    double altitude_rad = 0.0;
};

/// On the celestial sphere, of date.
struct Equatorial {
    double rightAscension_rad = 0.0;
    double declination_rad = 0.0;
};

/// An instant with its fraction of a second: days since J2000.0, UT.
struct SkyTime {
    double days = 0.0;
    static SkyTime of(core::Utc start, double seconds) {
        return {core::daysSinceJ2000(start) + seconds / 86'400.0};
    }
};

/// Geocentric, within 0.01 deg from 1950 to 2050 (chapter 25, low accuracy).
Equatorial sunOnSphere(SkyTime time);
/// Geocentric, within about 0.3 deg (principal terms of chapter 47).
Equatorial moonOnSphere(SkyTime time);

/// As seen from a place, no refraction.
Horizontal seenFrom(core::GeoPoint place, SkyTime time, Equatorial body);
/// Added by the air to a true altitude, standard conditions (Saemundsson, chapter 16).
double refraction_rad(double trueAltitude_rad);

/// Sun as seen, refraction included.
Horizontal sunSeen(core::GeoPoint place, SkyTime time);
struct Moon {
    Horizontal seen;      ///< with parallax
    double litShare = 0;  ///< of the disc, 0 new to 1 full
};
Moon moonSeen(core::GeoPoint place, SkyTime time);

}  // namespace sagara::render
