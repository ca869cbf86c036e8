#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Grid.h"
#include "core/base/LocalFrame.h"
#include "core/base/Problems.h"
#include "core/base/Result.h"
#include "core/base/Shapes.h"
#include "core/sea/Tide.h"
#include "core/world/Shore.h"
#include "core/world/Streams.h"

namespace sagara::core {

inline constexpr int kAreaDocumentVersion = 1;

/// A fender on a quay face: a rubber block that gives way along the outward normal of the face.
struct Fender {
    NorthEast position;  ///< on the face
    double thickness_m = 0.0;
    double width_m = 0.0;
    double stiffness_Npm = 0.0;
};

/// A straight quay face where ships lie. Seen from a to b the water is on the right hand.
struct Berth {
    struct Bollard {
        std::string id;
        NorthEast position;
    };
    std::string id;
    std::string name;
    Segment face;
    double depth_m = 0.0;  ///< alongside, below chart datum
    std::vector<Bollard> bollards;
    std::vector<Fender> fenders;

    NorthEast along() const;    ///< unit vector from a to b
    NorthEast outward() const;  ///< unit vector towards the water
};

/// Kinds of marks, IALA Maritime Buoyage System.
enum class MarkKind : std::uint8_t {
    Lighthouse,
    LateralPort,
    LateralStarboard,
    CardinalNorth,
    CardinalEast,
    CardinalSouth,
    CardinalWest,
    IsolatedDanger,
    SafeWater,
    Special,
    Leading,
    Beacon
};

/// A light as the light list prints it.
struct Light {
    std::string character;  ///< "Fl(2) W 15s"
    double height_m = 0.0;
    double range_M = 0.0;
};

struct Mark {
    std::string id;
    std::string name;
    MarkKind kind = MarkKind::Special;
    NorthEast position;
    bool floating = false;
    bool fictional = false;  ///< not in any open source: drawn with a note
    std::optional<Light> light;
};

struct Place {
    std::string id;
    std::string name;
    std::string kind;
    NorthEast position;
};

/// An exercise area: an area document in frame N about its datum. Immutable.
class Area {
public:
    std::string id;
    std::string name;
    std::string notice;
    std::vector<std::string> attribution;
    LocalFrame frame{{}};
    std::string timeZone;       ///< IANA name, for people
    int utcOffset_min = 0;      ///< east of Greenwich; the areas shipped have no daylight saving
    std::string ialaRegion;     ///< "A" or "B"
    std::string depthDatum;     ///< "LAT"
    std::string depthSource;    ///< "modelled: ..." or the survey
    double waveDepth_m = 0.0;   ///< for the dispersion of all waves here
    bool shoaling = false;      ///< waves shoal and break by the depth (core/sea/Nearshore.h)
    double holdingRatio = 1.0;  ///< of the ground, over the good ground anchors are rated in
    double meanTideLevel_m = 0.0;
    std::vector<TidalConstituent> tide;
    Streams streams;
    std::vector<std::vector<NorthEast>> land;  ///< closed rings, clockwise
    std::vector<std::vector<NorthEast>>
        context;  ///< coarser rings farther out, for the picture and the radar
    Shore shore;
    std::vector<Grid> depths;     ///< finest first; below chart datum, land negative
    std::vector<Grid> shelter;    ///< factor on wave height, 0 to 1
    std::vector<Grid> elevation;  ///< above mean sea level
    std::vector<Berth> berths;
    std::vector<Mark> marks;
    std::vector<Place> places;

    /// Below chart datum; beyond the grids the value of the edge of the coarsest.
    double depth_m(NorthEast p) const { return sample(depths, p); }
    double shelterFactor(NorthEast p) const { return shelter.empty() ? 1.0 : sample(shelter, p); }
    bool isLand(NorthEast p) const;
    const Berth* findBerth(std::string_view berthId) const;
    const Berth::Bollard* findBollard(std::string_view bollardId) const;
    const Place* findPlace(std::string_view placeId) const;

private:
    static double sample(const std::vector<Grid>& grids, NorthEast p);
};

Result<Area, config::Problems> loadArea(const std::string& name, std::string_view text);

}  // namespace sagara::core
