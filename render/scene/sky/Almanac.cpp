#include "render/scene/sky/Almanac.h"

#include <cmath>

#include "core/base/Angle.h"

namespace sagara::render {
namespace {

using core::kDegree_rad;
using core::kTwoPi;
using core::wrapTwoPi;

double sinDeg(double angle_deg) { return std::sin(angle_deg * kDegree_rad); }
double cosDeg(double angle_deg) { return std::cos(angle_deg * kDegree_rad); }

double obliquity_deg(double centuries) { return 23.4392911 - 0.0130042 * centuries; }

Equatorial fromEcliptic(double longitude_deg, double latitude_deg, double centuries) {
    const double e = obliquity_deg(centuries);
    const double x = cosDeg(longitude_deg) * cosDeg(latitude_deg);
    const double y = sinDeg(longitude_deg) * cosDeg(latitude_deg), z = sinDeg(latitude_deg);
    return {wrapTwoPi(std::atan2(y * cosDeg(e) - z * sinDeg(e), x)),
            std::asin(z * cosDeg(e) + y * sinDeg(e))};
}

/// Greenwich, mean: the equation of the equinoxes is below 0.005 deg.
double siderealAngle_rad(SkyTime time) {
    return std::fmod(280.46061837 + 360.98564736629 * time.days, 360.0) * kDegree_rad;
}

}  // namespace

Equatorial sunOnSphere(SkyTime time) {
    const double t = time.days / 36525.0;
    const double meanLongitude = 280.46646 + 36000.76983 * t;
    const double anomaly = 357.52911 + 35999.05029 * t;
    const double centre = (1.914602 - 0.004817 * t) * sinDeg(anomaly) +
                          (0.019993 - 0.000101 * t) * sinDeg(2.0 * anomaly) +
                          0.000289 * sinDeg(3.0 * anomaly);
    const double apparent = meanLongitude + centre - 0.00569 - 0.00478 * sinDeg(125.04 - 1934.136 * t);
    return fromEcliptic(apparent, 0.0, t);
}

Equatorial moonOnSphere(SkyTime time) {
    const double t = time.days / 36525.0;
    const double longitude = 218.3164477 + 481267.88123421 * t;
    const double elongation = 297.8501921 + 445267.1114034 * t;
    const double sun = 357.5291092 + 35999.0502909 * t;
    const double anomaly = 134.9633964 + 477198.8675055 * t;
    const double node = 93.2720950 + 483202.0175233 * t;
    const double l =
        longitude + 6.288774 * sinDeg(anomaly) + 1.274027 * sinDeg(2 * elongation - anomaly) +
        0.658314 * sinDeg(2 * elongation) + 0.213618 * sinDeg(2 * anomaly) - 0.185116 * sinDeg(sun) -
        0.114332 * sinDeg(2 * node) + 0.058793 * sinDeg(2 * elongation - 2 * anomaly) +
        0.057066 * sinDeg(2 * elongation - sun - anomaly) + 0.053322 * sinDeg(2 * elongation + anomaly) +
        0.045758 * sinDeg(2 * elongation - sun) - 0.040923 * sinDeg(sun - anomaly) -
        0.034720 * sinDeg(elongation) - 0.030383 * sinDeg(sun + anomaly);
    const double b = 5.128122 * sinDeg(node) + 0.280602 * sinDeg(anomaly + node) +
                     0.277693 * sinDeg(anomaly - node) + 0.173237 * sinDeg(2 * elongation - node) +
                     0.055413 * sinDeg(2 * elongation - anomaly + node) +
                     0.046271 * sinDeg(2 * elongation - anomaly - node);
    return fromEcliptic(l, b, t);
}

Horizontal seenFrom(core::GeoPoint place, SkyTime time, Equatorial body) {
    const double hourAngle = siderealAngle_rad(time) + place.lon_deg * kDegree_rad - body.rightAscension_rad;
    const double lat = place.lat_deg * kDegree_rad, dec = body.declination_rad;
    const double altitude =
        std::asin(std::sin(lat) * std::sin(dec) + std::cos(lat) * std::cos(dec) * std::cos(hourAngle));
    const double west = std::sin(hourAngle) * std::cos(dec);
    const double north = std::sin(dec) * std::cos(lat) - std::cos(dec) * std::sin(lat) * std::cos(hourAngle);
    return {wrapTwoPi(std::atan2(-west, north)), altitude};
}

double refraction_rad(double trueAltitude_rad) {
    const double h = std::max(-1.0, trueAltitude_rad / kDegree_rad);
    return 1.02 / 60.0 / std::tan((h + 10.3 / (h + 5.11)) * kDegree_rad) * kDegree_rad;
}

Horizontal sunSeen(core::GeoPoint place, SkyTime time) {
    Horizontal sun = seenFrom(place, time, sunOnSphere(time));
    sun.altitude_rad += refraction_rad(sun.altitude_rad);
    return sun;
}

Moon moonSeen(core::GeoPoint place, SkyTime time) {
    const Equatorial moon = moonOnSphere(time), sun = sunOnSphere(time);
    constexpr double kParallax_rad = 0.9507 * kDegree_rad;  // at mean distance
    Moon m;
    m.seen = seenFrom(place, time, moon);
    m.seen.altitude_rad -= kParallax_rad * std::cos(m.seen.altitude_rad);
    const double cosElongation = std::sin(moon.declination_rad) * std::sin(sun.declination_rad) +
                                 std::cos(moon.declination_rad) * std::cos(sun.declination_rad) *
                                     std::cos(moon.rightAscension_rad - sun.rightAscension_rad);
    m.litShare = 0.5 * (1.0 - cosElongation);
    return m;
}

}  // namespace sagara::render
