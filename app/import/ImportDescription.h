#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/LocalFrame.h"
#include "core/base/Problems.h"
#include "core/base/Result.h"
#include "core/world/Shore.h"

/// What an import description (import.json) says. Everything special to one place stands there; the code
/// knows no place.
namespace sagara::importer {

inline constexpr int kDescriptionVersion = 1;

/// A box with sides along meridians and parallels.
struct GeoBox {
    double south_deg = 0.0;
    double west_deg = 0.0;
    double north_deg = 0.0;
    double east_deg = 0.0;

    bool contains(core::GeoPoint p) const {
        return p.lat_deg > south_deg && p.lat_deg < north_deg && p.lon_deg > west_deg && p.lon_deg < east_deg;
    }
    bool covers(const GeoBox& inner) const {
        return south_deg <= inner.south_deg && west_deg <= inner.west_deg && north_deg >= inner.north_deg &&
               east_deg >= inner.east_deg;
    }
};

/// One grid wanted. Lists of them run from the finest to the coarsest, each inside the next.
struct GridRules {
    GeoBox box;
    double spacing_m = 1.0;
};

struct ShorelineRules {
    struct Category {
        std::string name;  ///< as the source calls it
        core::ShoreKind kind = core::ShoreKind::Other;
    };
    /// Another kind for the source's line nearest to a point.
    struct Correction {
        core::GeoPoint near;
        core::ShoreKind kind = core::ShoreKind::Other;
        std::string name;
    };
    std::string file;
    std::vector<Category> categories;
    std::vector<Correction> corrections;
};

struct TideRules {
    std::string file;
    std::string source;
    double leastAmplitude_m = 0.0;  ///< smaller constituents are left out
};

struct ElevationRules {
    std::string file;
    GridRules grid;
    double unit_m = 1.0;
    double landAtLeast_m = 0.0;  ///< land never lies lower: the source has zeros along the beach
};

/// A reported depth of the natural bed.
struct Sounding {
    core::GeoPoint at;
    double depth_m = 0.0;
    std::string source;
};

/// A part of the bed whose depth is known or wanted: a polygon, or a line with a width. Outside it the limits
/// are eased along the side slope.
struct BedRules {
    std::string name;
    std::vector<core::GeoPoint> points;
    bool isLine = false;
    double halfWidth_m = 0.0;  ///< of a line
    std::optional<double> atLeast_m;
    std::optional<double> atMost_m;
};

struct DepthRules {
    std::vector<GridRules> grids;
    double unit_m = 0.1;
    double profileCoefficient = 0.0;  ///< depth = coefficient * distance ^ exponent, both in metres
    double profileExponent = 1.0;
    double landAtMost_m = 0.0;       ///< land in the depth grids is cut off at this height
    double worksReach_m = 0.0;       ///< how far behind a quay or breakwater the water's depth is carried on
    double sideSlope = 0.1;          ///< rise over run of the sides of worked beds
    double soundingTolerance = 0.0;  ///< a sounding that the profile misses by a larger share bends the bed
    double soundingReach_m = 1.0;    ///< how far the bend goes: a Gaussian of this length
    std::vector<Sounding> soundings;
    std::vector<BedRules> beds;
};

struct ShelterRules {
    /// Waves from a sector, clockwise from `from_deg` to `to_deg`, and their share of the energy.
    struct Sector {
        double from_deg = 0.0;
        double to_deg = 0.0;
        double share = 1.0;
    };
    std::vector<GridRules> grids;
    double unit = 0.01;
    double waveLength_m = 100.0;
    double step_deg = 5.0;
    std::vector<Sector> sectors;
};

struct BerthRules {
    std::string id;
    std::string name;
    double depth_m = 0.0;
    core::GeoPoint a;  ///< seen from a to b the water is on the right hand
    core::GeoPoint b;
    std::string bollardPrefix;  ///< ids are prefix-01, prefix-02, ... from a, or from b
    bool numberedFromB = false;
    double bollardSpacing_m = 20.0;
    double bollardSetback_m = 0.0;  ///< behind the face
    double fenderSpacing_m = 10.0;
    double fenderThickness_m = 0.0;
    double fenderWidth_m = 0.0;
    double fenderStiffness_kNpm = 0.0;
};

struct ImportDescription {
    core::GeoPoint datum;
    GeoBox box;  ///< which the detailed land and shoreline fill
    std::string landFile;
    std::string contextFile;
    std::string placesFile;
    ShorelineRules shoreline;
    TideRules tide;
    ElevationRules elevation;
    DepthRules depth;
    ShelterRules shelter;
    std::vector<BerthRules> berths;
    std::string areaJson;  ///< members that go into the area document as they stand; its loader checks them
};

/// All problems of the description at once. `name` is used in messages.
core::Result<ImportDescription, core::config::Problems> loadImportDescription(const std::string& name,
                                                                              std::string_view text);

}  // namespace sagara::importer
