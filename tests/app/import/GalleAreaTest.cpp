#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "core/world/Area.h"
#include "tests/support/Assets.h"

/// Published facts about Galle, looked up in the committed document.
namespace sagara::core {
namespace {

const Area& galle() {
    static const auto loaded = loadArea("galle", test::readAsset("areas/galle/area.json"));
    if (!loaded) throw std::runtime_error(loaded.error().text());
    return *loaded;
}

NorthEast at(double lat_deg, double lon_deg) { return galle().frame.toLocal({lat_deg, lon_deg}); }
NorthEast place(const char* id) {
    const Place* found = galle().findPlace(id);
    if (!found) throw std::runtime_error(std::string("no place ") + id);
    return found->position;
}

/// Points every metre along a line of positions.
std::vector<NorthEast> everyMetre(const std::vector<NorthEast>& corners) {
    std::vector<NorthEast> all;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const double length_m = distance(corners[i - 1], corners[i]);
        for (double s_m = 0.0; s_m < length_m; s_m += 1.0) {
            all.push_back(corners[i - 1] + (s_m / length_m) * (corners[i] - corners[i - 1]));
        }
    }
    all.push_back(corners.back());
    return all;
}

/// New Pier to the 18 m anchorage, the RTZ route published with the data of the area (own work, CC0).
std::vector<NorthEast> route() {
    return {at(6.03225, 80.2302), at(6.03275, 80.2286), at(6.03292, 80.22744),  at(6.03255, 80.2258),
            at(6.0295, 80.2250),  at(6.0230, 80.2255),  at(6.007185, 80.227506)};
}
/// The same with a wider turn outside the entrance.
std::vector<NorthEast> wideRoute() {
    std::vector<NorthEast> corners = route();
    corners[3] = at(6.03255, 80.2249);
    return corners;
}

TEST(GalleArea, SaysWhatItIs) {
    const Area& a = galle();
    EXPECT_EQ(a.id, "galle");
    EXPECT_EQ(a.timeZone, "Asia/Colombo");
    EXPECT_EQ(a.utcOffset_min, 330);
    EXPECT_EQ(a.ialaRegion, "A");
    EXPECT_EQ(a.depthDatum, "LAT");
    EXPECT_EQ(a.depthSource.rfind("modelled", 0), 0u);
    EXPECT_EQ(a.notice, "Training approximation. Not for navigation. Depths are modelled.");
    EXPECT_EQ(a.holdingRatio, 1.0);
    EXPECT_EQ(a.places.size(), 28u);  // 32 rows of the source, 4 without a position
}

struct DepthFact {
    const char* name;
    double lat_deg, lon_deg, depth_m, tolerance_m;
    const char* source;
};
// Tolerance 0.1 m: one unit of the grid, and bilinear between its nodes. 0.5 m where the profile alone is
// meant.
const DepthFact kDepthFacts[] = {
    {"watering_point", 6.020267, 80.236283, 10.0, 0.1, "yacht blog 2006; the bed is bent to it"},
    {"ne_monsoon_anchorage", 6.007185, 80.227506, 18.0, 0.5,
     "sailing directions quoted 2001; profile within 10 %"},
    {"sw_monsoon_anchorage", 6.004993, 80.21518, 27.0, 0.5,
     "sailing directions quoted 2001; profile within 10 %"},
    {"entrance", 6.033, 80.2272, 9.4, 0.1, "World Port Index 49250, channel depth"},
    {"basin", 6.0331, 80.2295, 9.4, 0.1, "the same, carried on through the basin"},
    {"new_pier", 6.03190, 80.2306, 8.9, 0.1, "World Port Index 49250, cargo pier; 4 m off the face"},
    {"fishery_harbour", 6.035, 80.2282, 4.0, 0.1, "assumed"},
};
class GalleDepth : public ::testing::TestWithParam<DepthFact> {};
TEST_P(GalleDepth, IsThePublishedOne) {
    const DepthFact& f = GetParam();
    EXPECT_NEAR(galle().depth_m(at(f.lat_deg, f.lon_deg)), f.depth_m, f.tolerance_m) << f.source;
}
INSTANTIATE_TEST_SUITE_P(Published, GalleDepth, ::testing::ValuesIn(kDepthFacts),
                         [](const auto& row) { return row.param.name; });

TEST(GalleArea, TheNewPierIsDeepRightUpToItsFace) {
    const Berth& pier = *galle().findBerth("new-pier");
    for (const NorthEast p : everyMetre({pier.face.a, pier.face.b})) {
        for (const double off_m : {5.0, 2.0, 0.5}) {
            // 8.9 m and a unit of the grid either way
            EXPECT_NEAR(galle().depth_m(p + off_m * pier.outward()), 8.9, 0.1 + 1e-6)
                << off_m << " m off the face";
        }
    }
}

TEST(GalleArea, TheNewPierLiesAsMeasured) {
    const Berth& pier = *galle().findBerth("new-pier");
    EXPECT_NEAR(distance(pier.face.a, pier.face.b), 415.0, 1.0);  // measured to the metre on the same polygon
    EXPECT_NEAR(wrapTwoPi(bearing_rad(pier.face.a, pier.face.b)) / kDegree_rad, 260.0, 1.0);
    EXPECT_GT(pier.outward().north_m, 0.9);  // the water is to the north
    EXPECT_EQ(pier.bollards.front().id, "np-01");
    EXPECT_LT(pier.bollards.front().position.east_m, pier.bollards.back().position.east_m);
}

TEST(GalleArea, TheEntranceIs214MetresWide) {
    const auto headOf = [](const char* mark, const char* name) {
        // The vertex of the breakwater nearest to the other head.
        const NorthEast other = place(mark);
        NorthEast best{1e9, 1e9};
        for (const ShoreLine& line : galle().shore.lines()) {
            if (line.kind != ShoreKind::Breakwater || line.name != name) continue;
            for (const NorthEast p : line.points) {
                if (distance(p, other) < distance(best, other)) best = p;
            }
        }
        return best;
    };
    const NorthEast south = headOf("w_breakwater_head", "South breakwater");
    const NorthEast west = headOf("s_breakwater_head", "West breakwater (fishery harbour)");
    EXPECT_NEAR(distance(south, west), 214.0, 2.0);  // published to the metre, between slightly other points
}

TEST(GalleArea, BollardsStandOnTheQuayAndFendersOnItsFace) {
    for (const Berth& berth : galle().berths) {
        EXPECT_GE(berth.bollards.size(), 7u) << berth.id;
        for (const auto& bollard : berth.bollards) {
            const double off_m = dot(bollard.position - berth.face.a, berth.outward());
            EXPECT_LT(off_m, 0.0) << bollard.id;
            EXPECT_GT(off_m, -1.5) << bollard.id;
            EXPECT_LT(galle().shore.distance_m(bollard.position, 10.0), 1.5) << bollard.id;
            EXPECT_TRUE(galle().isLand(bollard.position)) << bollard.id;
        }
        for (const Fender& fender : berth.fenders) {
            EXPECT_LT(distanceTo(berth.face, fender.position), 0.02);  // seven decimals of a degree are 1 cm
        }
    }
    EXPECT_EQ(galle().findBerth("new-pier")->fenders.size(), 41u);
}

TEST(GalleArea, TheRouteIsDeepAndClear) {
    for (const auto& corners : {route(), wideRoute()}) {
        for (const NorthEast p : everyMetre(corners)) {
            EXPECT_GE(galle().depth_m(p), 7.0);
            EXPECT_GE(galle().shore.distance_m(p, 100.0), 48.0 - 0.5);  // published to the metre
            EXPECT_FALSE(galle().isLand(p));
        }
    }
}

TEST(GalleArea, TheDredgedWayIsNineMetresFromTheBasinOut) {
    std::vector<NorthEast> corners = wideRoute();
    corners.erase(corners.begin());
    for (const NorthEast p : everyMetre(corners))
        EXPECT_GE(galle().depth_m(p), 9.4 - 0.05);  // half a unit of the grid
}

TEST(GalleArea, MarksAreClearOfTheRouteAndInDeepWater) {
    for (const Mark& mark : galle().marks) {
        EXPECT_EQ(mark.fictional, mark.id != "galle-light") << mark.id;
        EXPECT_EQ(mark.fictional, mark.name.find("(fictional)") != std::string::npos) << mark.id;
        EXPECT_EQ(mark.floating, !galle().isLand(mark.position)) << mark.id;
        if (!mark.floating) continue;
        EXPECT_GT(galle().depth_m(mark.position), 5.0) << mark.id;
        for (const auto& corners : {route(), wideRoute()}) {
            for (const NorthEast p : everyMetre(corners))
                EXPECT_GT(distance(p, mark.position), 60.0) << mark.id;
        }
    }
}

/// Region A: inbound, red (port hand) to port, green to starboard.
TEST(GalleArea, LateralMarksStandOnTheirSideInbound) {
    std::vector<NorthEast> inbound = everyMetre(wideRoute());
    std::reverse(inbound.begin(), inbound.end());
    for (const Mark& mark : galle().marks) {
        if (mark.kind != MarkKind::LateralPort && mark.kind != MarkKind::LateralStarboard) continue;
        std::size_t nearest = 1;
        for (std::size_t i = 1; i < inbound.size(); ++i) {
            if (distance(inbound[i], mark.position) < distance(inbound[nearest], mark.position)) nearest = i;
        }
        const double starboard =
            cross(inbound[nearest] - inbound[nearest - 1], mark.position - inbound[nearest]);
        EXPECT_EQ(starboard > 0.0, mark.kind == MarkKind::LateralStarboard) << mark.id;
    }
}

TEST(GalleArea, LeadingMarksLeadThroughTheEntrance) {
    const auto mark = [](const char* id) {
        for (const Mark& m : galle().marks) {
            if (m.id == id) return m.position;
        }
        return NorthEast{};
    };
    const double line_rad = bearing_rad(mark("leading-front"), mark("leading-rear"));
    for (const NorthEast p : {at(6.03255, 80.2249), at(6.03292, 80.22744)}) {
        // 5 m beside the line in 800 m: the marks are placed to 1e-5 deg, a metre, and 190 m apart
        EXPECT_LT(std::abs(cross(unitVector(line_rad), p - mark("leading-front"))), 5.0);
    }
}

struct ShelterFact {
    const char* name;
    double lat_deg, lon_deg, low, high;
};
const ShelterFact kShelterFacts[] = {
    {"open_sea", 5.99, 80.20, 1.0, 1.0},
    {"sw_monsoon_anchorage", 6.004993, 80.21518, 1.0, 1.0},
    {"ne_monsoon_anchorage", 6.007185, 80.227506, 0.98, 1.0},
    {"bay_off_the_fort", 6.0245, 80.2245, 0.6, 1.0},
    {"entrance", 6.033, 80.2272, 0.3, 0.7},
    {"alongside_new_pier_west", 6.0318, 80.2292, 0.05, 0.2},
    {"alongside_new_pier_east", 6.0322, 80.2318, 0.05, 0.2},
    {"basin", 6.0331, 80.2295, 0.05, 0.25},
    {"in_the_fort", 6.0268, 80.2168, 0.0, 0.1},
    {"inland", 6.045, 80.24, 0.0, 0.1},
};
class GalleShelter : public ::testing::TestWithParam<ShelterFact> {};
TEST_P(GalleShelter, IsWhatAPilotWouldExpect) {
    const double factor = galle().shelterFactor(at(GetParam().lat_deg, GetParam().lon_deg));
    EXPECT_GE(factor, GetParam().low - 1e-6);
    EXPECT_LE(factor, GetParam().high + 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Places, GalleShelter, ::testing::ValuesIn(kShelterFacts),
                         [](const auto& row) { return row.param.name; });

/// A ship must not feel a step: along the route the factor changes by less than 2 % of the open sea's waves
/// per metre, also where the fine grid begins.
TEST(GalleArea, ShelterComesGradually) {
    const std::vector<NorthEast> way = everyMetre(wideRoute());
    for (std::size_t i = 1; i < way.size(); ++i) {
        EXPECT_NEAR(galle().shelterFactor(way[i]), galle().shelterFactor(way[i - 1]), 0.02);
    }
}

struct Levels {
    double low_m = 1e9;
    double high_m = -1e9;
};
Levels levelsOf(int year) {
    const TidePrediction tide(galle().meanTideLevel_m, galle().tide,
                              *parseUtc(std::to_string(year) + "-01-01T00:00:00Z"));
    Levels found;
    for (std::int64_t s = 0; s < 365 * 86400; s += 600) {
        const double height_m = tide.height_m(SimTime::fromSeconds(s));
        found.low_m = std::min(found.low_m, height_m);
        found.high_m = std::max(found.high_m, height_m);
    }
    return found;
}

/// Datums of the tide table, Colombo: LAT is zero and HAT 0.975 m above it, over the 18.6 years of the node.
/// A single year stays between them, within 5 cm for the constituents left out, and comes within 8 cm of
/// both.
TEST(GalleArea, TideReachesThePublishedExtremesAndKeepsToThem) {
    constexpr double kHighest_m = 1.784 - 0.809;
    for (const int year : {2018, 2024, 2027, 2036}) {
        const Levels levels = levelsOf(year);
        EXPECT_GT(levels.low_m, -0.05) << year;
        EXPECT_LT(levels.low_m, 0.08) << year;
        EXPECT_GT(levels.high_m, kHighest_m - 0.08) << year;
        EXPECT_LT(levels.high_m, kHighest_m + 0.05) << year;
    }
}

/// MHWS - MLWS of the same table: 1.572 - 0.970 m; by definition twice the sum of M2 and S2. 1 cm: how the
/// table's authors averaged is not known.
TEST(GalleArea, MeanSpringRangeIsThePublishedOne) {
    double sum_m = 0.0;
    for (const TidalConstituent& c : galle().tide) {
        if (c.name == "M2" || c.name == "S2") sum_m += c.amplitude_m;
    }
    EXPECT_NEAR(2.0 * sum_m, 0.602, 0.01);
}

}  // namespace
}  // namespace sagara::core
