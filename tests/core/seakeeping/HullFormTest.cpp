#include "core/seakeeping/HullForm.h"

#include <gtest/gtest.h>

#include "ReferenceHull.h"
#include "core/seakeeping/Hydrostatics.h"
#include "core/vessel/Vessel.h"
#include "tests/support/Assets.h"

namespace sagara::core {
namespace {

TEST(HullForm, WhatIsNullIsEstimatedAndTold) {
    const auto form = readHullForm("barge.json", R"({"length_pp_m": 100, "breadth_m": 20, "draught_m": 5,
        "volume_m3": null, "mass_kg": null, "rho_kgpm3": null, "xg_m": null, "zg_m": null, "kxx_m": null,
        "kyy_m": null, "kzz_m": null, "gm_transverse_m": 2.0, "roll_damping_added_Nms": null,
        "stations": [[-50, 20, 5, 100, 2.5], [-25, 20, 5, 100, 2.5], [0, 20, 5, 100, 2.5], [25, 20, 5, 100, 2.5],
                     [50, 20, 5, 100, 2.5]]})");
    ASSERT_TRUE(form) << form.error().text();
    EXPECT_DOUBLE_EQ(form->mass_kg, 10000.0 * 1025.0);
    EXPECT_NEAR(hydrostaticsOf(*form).transverseGM_m, 2.0, 1e-9);
    EXPECT_NEAR(form->rollGyradius_m, 7.4, 1e-9);
    EXPECT_NEAR(form->gravityForward_m, 0.0, 1e-9);
    EXPECT_EQ(form->notes.size(), 8u);
}

/// So `rao --vessel` gives what `rao --hull` of the reference gives; 5415 floats in sea water as a vessel.
TEST(HullForm, OfAShippedVesselIsThatOfItsReference) {
    for (const std::string name : {"s175", "dtmb5415"}) {
        const HullForm reference = referenceHull(name);
        const auto vessel = loadVessel(name, test::readAsset("vessels/" + name + ".json"));
        ASSERT_TRUE(vessel) << vessel.error().text();
        const HullForm form = hullFormOf(vessel->hull);
        ASSERT_EQ(form.stations.size(), reference.stations.size());
        for (std::size_t i = 0; i < form.stations.size(); ++i) {
            EXPECT_NEAR(form.stations[i].area_m2, reference.stations[i].area_m2, 1e-3);
            EXPECT_NEAR(form.stations[i].centroid_m, reference.stations[i].centroid_m, 1e-3);
        }
        const double mass_m3 = reference.mass_kg / reference.waterDensity_kgpm3;
        EXPECT_NEAR(form.mass_kg / form.waterDensity_kgpm3, mass_m3, 2e-4 * mass_m3);
        EXPECT_NEAR(form.gravityHeight_m, reference.gravityHeight_m, 1e-3);
        EXPECT_NEAR(form.gravityForward_m, reference.gravityForward_m, 0.002 * form.lengthBp_m);
        EXPECT_NEAR(form.rollGyradius_m, reference.rollGyradius_m, 1e-3);
        EXPECT_NEAR(form.pitchGyradius_m, reference.pitchGyradius_m, 1e-3);
        EXPECT_EQ(form.bilgeKeelLength_m, reference.bilgeKeelLength_m);
    }
}

TEST(HullForm, OffsetsOfABoxAreABox) {
    const auto form = readHullForm("box", R"({"length_pp_m": 100, "breadth_m": 20, "draught_m": 5,
        "waterlines_m": [0, 2, 4, 8], "offsets": [[-50, 10, 10, 10, 10], [-25, 10, 10, 10, 10], [0, 10, 10, 10, 10],
        [25, 10, 10, 10, 10], [50, 10, 10, 10, 10]]})");
    ASSERT_TRUE(form) << form.error().text();
    const Hydrostatics h = hydrostaticsOf(*form);
    EXPECT_NEAR(h.volume_m3, 10000.0, 1e-6);
    EXPECT_NEAR(h.buoyancyHeight_m, 2.5, 1e-9);
    EXPECT_NEAR(h.transverseBM_m, 20.0 / 3.0, 1e-3);
}

TEST(HullForm, CoefficientsAloneMakeAHullOfThem) {
    const auto form =
        readHullForm("ship", R"({"length_pp_m": 150, "breadth_m": 24, "draught_m": 8, "Cb": 0.62,
        "Cm": 0.97, "Cw": 0.75, "stations": null})");
    ASSERT_TRUE(form) << form.error().text();
    const Hydrostatics h = hydrostaticsOf(*form);
    EXPECT_NEAR(h.blockCoefficient, 0.62, 0.0062);
    EXPECT_NEAR(h.waterplaneCoefficient, 0.75, 0.0075);
    EXPECT_NEAR(h.midshipCoefficient, 0.97, 0.0097);
}

TEST(HullForm, EveryProblemIsTold) {
    const auto form = readHullForm("bad.json", R"({"length_pp_m": -3, "breadth_m": 20, "draught_m": "deep",
        "stations": [[0, 1, 1, 1], [1, -2, 1, 1, 1]]})");
    ASSERT_FALSE(form);
    EXPECT_EQ(form.error().messages().size(), 5u) << form.error().text();
    EXPECT_FALSE(readHullForm("empty.json", R"({"length_pp_m": 3, "breadth_m": 1, "draught_m": 1})"));
    EXPECT_FALSE(readHullForm("none.json", "{"));
}

TEST(HullForm, HullOfAVesselKeepsHerMetacentricHeightAndMass) {
    for (const char* name : {"patrol51", "esso-osaka"}) {
        const Vessel vessel =
            loadVessel(name, test::readAsset("vessels/" + std::string(name) + ".json")).value();
        const HullForm form = hullFormOf(vessel.hull);
        const Hydrostatics h = hydrostaticsOf(form);
        EXPECT_NEAR(h.transverseGM_m, vessel.hull.metacentricHeight_m, 1e-9) << name;
        EXPECT_DOUBLE_EQ(form.mass_kg, vessel.hull.mass_kg());
        EXPECT_NEAR(h.volume_m3, vessel.hull.displacement_m3, 0.02 * vessel.hull.displacement_m3) << name;
    }
}

TEST(HullForm, BilgeKeelsOfAVesselAreHersOrThoseOfUsualShips) {
    Hull hull = loadVessel("patrol51", test::readAsset("vessels/patrol51.json")).value().hull;
    EXPECT_NEAR(hullFormOf(hull).bilgeKeelLength_m, 0.25 * hull.lengthBp_m, 1e-9);
    hull.bilgeKeelLength_m = 0.0;
    EXPECT_EQ(hullFormOf(hull).bilgeKeelLength_m, 0.0);
}

}  // namespace
}  // namespace sagara::core
