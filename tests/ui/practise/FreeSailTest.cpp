#include "ui/practise/FreeSail.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/Units.h"
#include "core/exercise/Advance.h"
#include "tests/support/Assets.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::ui {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> shipped(const char* folder) {
    std::vector<std::string> ids;
    for (const auto& entry : fs::directory_iterator(fs::path(SAGARA_ASSETS) / folder)) {
        if (entry.is_directory()) ids.push_back(entry.path().filename().string());
        if (entry.path().extension() == ".json") ids.push_back(entry.path().stem().string());
    }
    return ids;
}

const core::Area& area(const std::string& id) {
    static std::map<std::string, core::Area> read;
    const auto it = read.find(id);
    if (it != read.end()) return it->second;
    auto loaded = core::loadArea(id, test::readAsset("areas/" + id + "/area.json"));
    return read.emplace(id, std::move(loaded).value()).first->second;
}

core::Vessel vessel(const std::string& id) {
    return core::loadVessel(id, test::readAsset("vessels/" + id + ".json")).value();
}

FreeSail sailFrom(const std::string& areaId, const std::string& vesselId, const SailPlace& place) {
    FreeSail sail;
    sail.shipName = "Practice";
    sail.vessel = vesselId;
    sail.area = areaId;
    sail.place = place;
    sail.heading_deg = place.heading_deg;
    sail.speed_kn = 6.0;
    return sail;
}

TEST(FreeSail, EveryShippedVesselBuildsAtEveryPlaceOfferedToHer) {
    for (const std::string& areaId : shipped("areas"))
        for (const std::string& vesselId : shipped("vessels")) {
            const auto places = placesFor(area(areaId), vessel(vesselId));
            EXPECT_FALSE(places.empty()) << vesselId << " has nowhere to go in " << areaId;
            for (const SailPlace& place : places)
                EXPECT_EQ(test::problemsOf(freeSailScenario(sailFrom(areaId, vesselId, place))), "")
                    << vesselId << " at " << place.id;
        }
}

TEST(FreeSail, OffersABerthToThePatrolVesselAndOnlyDeepWaterToTheTanker) {
    const auto patrol = placesFor(area("galle"), vessel("patrol51"));
    EXPECT_TRUE(
        std::any_of(patrol.begin(), patrol.end(), [](const SailPlace& p) { return p.berth == "new-pier"; }));
    EXPECT_TRUE(std::any_of(patrol.begin(), patrol.end(),
                            [](const SailPlace& p) { return p.id == "anch_ne_monsoon"; }));
    for (const SailPlace& place : placesFor(area("galle"), vessel("esso-osaka"))) {
        EXPECT_FALSE(place.alongside()) << place.name;
        EXPECT_GT(place.depth_m, 21.73) << place.name;
    }
}

TEST(FreeSail, HasNoMissionStartsAsOrderedAndGoesOn) {
    const auto places = placesFor(area("galle"), vessel("patrol51"));
    const auto sea =
        std::find_if(places.begin(), places.end(), [](const SailPlace& p) { return !p.alongside(); });
    ASSERT_NE(sea, places.end());
    FreeSail sail = sailFrom("galle", "patrol51", *sea);
    sail.heading_deg = 123.0;
    sail.weather.wind_kn = 21.0;
    sail.weather.swell_m = 0.0;
    sail.weather.startUtc = "2027-06-20T14:30:00Z";
    const auto world = test::worldOf(freeSailScenario(sail));
    EXPECT_TRUE(world->mission.tasks.empty());
    EXPECT_TRUE(world->mission.criteria.empty());
    EXPECT_NEAR(world->ships[0]->start.heading_rad, 123.0 * core::kDegree_rad, 1e-12);
    EXPECT_NEAR(world->ships[0]->start.surge_mps, 6.0 * core::kKnot_mps, 1e-12);
    const SailWeather back = sailWeatherOf(*world);
    EXPECT_NEAR(back.wind_kn, 21.0, 1e-9);
    EXPECT_EQ(back.swell_m, 0.0);
    EXPECT_EQ(back.startUtc, "2027-06-20T14:30:00Z");
    core::State state = core::startState(*world, 3);
    for (int i = 0; i < 500; ++i) core::advance(*world, state);
    EXPECT_FALSE(state.finished);
    EXPECT_FALSE(state.stopped);
}

TEST(FreeSail, TakesThePeacefulTrafficOfALesson) {
    const std::string traffic = peacefulTraffic(test::lessonText());
    EXPECT_EQ(traffic.find("hostile"), std::string::npos);
    EXPECT_NE(traffic.find("MV Ruhunu"), std::string::npos);
    for (const SailPlace& place : placesFor(area("galle"), vessel("patrol51"))) {
        FreeSail sail = sailFrom("galle", "patrol51", place);
        sail.traffic = traffic;
        EXPECT_EQ(test::problemsOf(freeSailScenario(sail)), "") << place.id;
    }
}

TEST(FreeSail, ALessonKeepsItsMissionInOtherWeather) {
    SailWeather weather;
    weather.wind_kn = 33.0;
    weather.visibility_M = 0.5;
    weather.rain = 1.0;
    const auto world = test::worldOf(withWeather(test::lessonText(), weather));
    EXPECT_EQ(world->scenarioId, "basic-navigation");
    EXPECT_EQ(world->mission.tasks.size(), 5u);
    EXPECT_NEAR(sailWeatherOf(*world).wind_kn, 33.0, 1e-9);
    EXPECT_NEAR(sailWeatherOf(*world).visibility_M, 0.5, 1e-9);
    EXPECT_EQ(withWeather("no json", weather), "no json");
}

}  // namespace
}  // namespace sagara::ui
