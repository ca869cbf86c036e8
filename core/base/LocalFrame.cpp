#include "core/base/LocalFrame.h"

#include <GeographicLib/AzimuthalEquidistant.hpp>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

const GeographicLib::AzimuthalEquidistant& projection() {
    static const GeographicLib::AzimuthalEquidistant wgs84(GeographicLib::Geodesic::WGS84());
    return wgs84;
}

}  // namespace

NorthEast LocalFrame::toLocal(GeoPoint p) const {
    NorthEast local;
    projection().Forward(m_datum.lat_deg, m_datum.lon_deg, p.lat_deg, p.lon_deg, local.east_m, local.north_m);
    return local;
}

GeoPoint LocalFrame::toGeo(NorthEast p) const {
    GeoPoint geo;
    projection().Reverse(m_datum.lat_deg, m_datum.lon_deg, p.east_m, p.north_m, geo.lat_deg, geo.lon_deg);
    return geo;
}

double LocalFrame::convergence_rad(NorthEast p) const {
    // The projection keeps the bearing from the datum; the azimuth of the same geodesic at p differs by the
    // turning of north between the two.
    double lat = 0.0, lon = 0.0, azimuth_deg = 0.0, scale = 0.0;
    projection().Reverse(m_datum.lat_deg, m_datum.lon_deg, p.east_m, p.north_m, lat, lon, azimuth_deg, scale);
    return bearing_rad({}, p) - azimuth_deg * kDegree_rad;
}

}  // namespace sagara::core
