#pragma once

#include "core/base/Planar.h"

namespace sagara::core {

/// WGS 84, degrees, as in files.
struct GeoPoint {
    double lat_deg = 0.0;
    double lon_deg = 0.0;
    friend bool operator==(const GeoPoint&, const GeoPoint&) = default;
};

/// Frame N of an area: azimuthal equidistant about the datum (GeographicLib), so distances and bearings from
/// the datum are exact and elsewhere within 1e-8 of the distance squared over the earth radius squared. Use
/// within 100 km of the datum.
class LocalFrame {
public:
    explicit LocalFrame(GeoPoint datum) : m_datum(datum) {}

    GeoPoint datum() const { return m_datum; }
    NorthEast toLocal(GeoPoint p) const;
    GeoPoint toGeo(NorthEast p) const;
    /// Angle of true north at the point, clockwise from frame north. True heading = frame heading -
    /// convergence.
    double convergence_rad(NorthEast p) const;

private:
    GeoPoint m_datum;
};

}  // namespace sagara::core
