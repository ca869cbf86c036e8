#include "app/import/GeoLayer.h"

#include <ogrsf_frmts.h>

#include "app/import/Gdal.h"

namespace sagara::importer {
namespace {

using core::GeoPoint;
using core::config::Problems;

const char* nameOf(GeoShape shape) {
    switch (shape) {
        case GeoShape::Point:
            return "a point";
        case GeoShape::Line:
            return "a line or several lines";
        case GeoShape::Polygon:
            return "a polygon without holes, or several";
    }
    return "";
}

std::vector<GeoPoint> pointsOf(const OGRSimpleCurve& curve) {
    std::vector<GeoPoint> points;
    points.reserve(static_cast<std::size_t>(curve.getNumPoints()));
    for (int i = 0; i < curve.getNumPoints(); ++i) points.push_back({curve.getY(i), curve.getX(i)});
    return points;
}

bool addRing(const OGRPolygon& polygon, GeoFeature& feature) {
    const OGRLinearRing* ring = polygon.getExteriorRing();
    if (!ring || ring->getNumPoints() < 4 || polygon.getNumInteriorRings() > 0) return false;
    feature.parts.push_back(pointsOf(*ring));
    feature.parts.back().pop_back();
    return true;
}

bool addParts(const OGRGeometry& geometry, GeoShape shape, GeoFeature& feature) {
    const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (const auto kind = wkbFlatten(type); kind == wkbMultiLineString || kind == wkbMultiPolygon) {
        for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
            if (!addParts(*part, shape, feature)) return false;
        }
        return true;
    }
    if (shape == GeoShape::Point && type == wkbPoint) {
        feature.parts.push_back({{geometry.toPoint()->getY(), geometry.toPoint()->getX()}});
        return true;
    }
    if (shape == GeoShape::Line && type == wkbLineString && geometry.toLineString()->getNumPoints() >= 2) {
        feature.parts.push_back(pointsOf(*geometry.toLineString()));
        return true;
    }
    return shape == GeoShape::Polygon && type == wkbPolygon && addRing(*geometry.toPolygon(), feature);
}

bool onEarth(const GeoFeature& feature) {
    for (const auto& part : feature.parts) {
        for (const GeoPoint p : part) {
            if (!(p.lat_deg >= -90.0 && p.lat_deg <= 90.0 && p.lon_deg >= -180.0 && p.lon_deg <= 180.0))
                return false;
        }
    }
    return true;
}

GeoFeature readFeature(const OGRFeature& source, std::string path, GeoShape shape, Problems& problems) {
    GeoFeature feature;
    feature.path = std::move(path);
    for (int i = 0; i < source.GetFieldCount(); ++i) {
        if (!source.IsFieldSetAndNotNull(i)) continue;
        feature.properties[source.GetFieldDefnRef(i)->GetNameRef()] = source.GetFieldAsString(i);
    }
    const OGRGeometry* geometry = source.GetGeometryRef();
    if (geometry && !addParts(*geometry, shape, feature)) {
        problems.add({feature.path, std::string("is a ") + geometry->getGeometryName(), nameOf(shape)});
    } else if (!onEarth(feature)) {
        problems.add({feature.path, "has a position off the earth", "longitude, latitude in degrees"});
    }
    return feature;
}

}  // namespace

std::string GeoFeature::property(const std::string& key) const {
    const auto it = properties.find(key);
    return it == properties.end() ? "" : it->second;
}

std::vector<GeoFeature> readGeoLayer(const std::filesystem::path& file, GeoShape shape, Problems& all) {
    std::vector<GeoFeature> features;
    Problems problems(file.filename().string());
    const GDALDatasetUniquePtr dataset = openDataset(file, GDAL_OF_VECTOR, "GeoJSON", problems);
    OGRLayer* layer = dataset ? dataset->GetLayer(0) : nullptr;
    if (layer && isWgs84(layer->GetSpatialRef(), problems)) {
        std::size_t number = 0;
        for (const OGRFeatureUniquePtr& source : *layer) {
            const std::string path = "features[" + std::to_string(number++) + "]";
            GeoFeature feature = readFeature(*source, path, shape, problems);
            if (!feature.parts.empty()) features.push_back(std::move(feature));
        }
        if (features.empty() && problems.empty()) problems.add({"features", "is empty", nameOf(shape)});
    }
    if (!problems.empty()) all.append(problems);
    return features;
}

}  // namespace sagara::importer
