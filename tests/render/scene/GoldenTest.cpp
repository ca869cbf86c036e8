// Eight pictures against those kept in golden/. With SAGARA_WRITE_GOLDEN set they are written anew instead:
// look at each before it is committed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "PngReader.h"
#include "core/exercise/Session.h"
#include "core/sea/Beaufort.h"
#include "render/scene/Stage.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::render {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 320, kHeight = 180;
/// Mean difference of 255 that is let pass. On one version of Mesa's llvmpipe pictures are equal to the bit;
/// another may round edges and mipmaps differently.
constexpr double kTolerance = 1.5;

struct Scene {
    const char* name;
    const char* startUtc;
    double wind_kn;
    double visibility_M;
    double rain;
    enum class From { Bridge, Chase, Entrance, Fort, Coaster } from;
};
using From = Scene::From;
constexpr const char* kMorning = "2027-01-15T03:30:00Z";
const Scene kScenes[] = {
    {"berth", kMorning, 8.5, 10.0, 0.0, From::Chase},
    {"bridge", kMorning, 8.5, 10.0, 0.0, From::Bridge},
    {"entrance", "2027-01-15T06:30:00Z", 8.5, 10.0, 0.0, From::Entrance},
    {"fort-dusk", "2027-01-15T12:35:00Z", 8.5, 10.0, 0.0, From::Fort},
    {"entrance-night", "2027-01-15T15:30:00Z", 8.5, 10.0, 0.0, From::Entrance},
    {"coaster-night", "2027-01-15T15:30:00Z", 8.5, 10.0, 0.0, From::Coaster},
    {"fog", kMorning, 8.5, 0.1, 0.0, From::Chase},
    {"beaufort-7-rain", kMorning, 30.0, 3.0, 0.7, From::Coaster},
};

std::shared_ptr<const core::World> worldOf(const Scene& s) {
    std::string text = test::lessonWith("/startUtc", '"' + std::string(s.startUtc) + '"');
    text = test::with(text, "/weather/wind/speed_kn", std::to_string(s.wind_kn));
    text = test::with(text, "/weather/visibility_M", std::to_string(s.visibility_M));
    return test::worldOf(test::with(text, "/weather/rain", std::to_string(s.rain)));
}

Camera cameraOf(const Scene& s, const core::World& world, const Moment& m) {
    const Lens lens = Lens::symmetric(1.0, kWidth, kHeight);
    const auto at = [&](double lat, double lon) { return world.area.frame.toLocal({lat, lon}); };
    switch (s.from) {
        case From::Bridge:
            return bridgeCamera(world, m, 0, 0.9, lens);
        case From::Chase:
            return chaseCamera(m.ships[0], 54.0, 0.5, lens);
        case From::Entrance:
            return shoreCamera(at(6.0320, 80.2240), 10.0, at(6.03292, 80.22744), 6.0, lens);
        case From::Fort:
            return shoreCamera(at(6.0225, 80.2215), 10.0, at(6.0255, 80.2185), 12.0, lens);
        case From::Coaster:
            break;
    }
    const core::NorthEast ship = m.targets.at(0).position;
    return shoreCamera(ship + core::NorthEast{90.0, -60.0}, 15.0, ship, 4.0, lens);
}

double difference(const Picture& a, const Picture& b) {
    if (a.bgra.size() != b.bgra.size()) return 255.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < a.bgra.size(); ++i) {
        if (i % 4 != 3) sum += std::abs(a.bgra[i] - b.bgra[i]);
    }
    return sum / (0.75 * static_cast<double>(a.bgra.size()));
}

TEST(Golden, EightPicturesAreAsTheyWere) {
    auto opened = Stage::open({SAGARA_ASSETS, Preset::Medium, true});
    ASSERT_TRUE(opened) << opened.error();
    Stage& stage = **opened;
    const auto view = stage.addViewport(kWidth, kHeight);
    const fs::path golden(SAGARA_GOLDEN), found = fs::temp_directory_path() / "sagara-golden";
    for (const Scene& s : kScenes) {
        const auto world = worldOf(s);
        ASSERT_FALSE(stage.show(world));
        const Moment moment = momentOf(core::view(*world, core::startState(*world, 3)));
        view->setCamera(cameraOf(s, *world, moment));
        ASSERT_FALSE(stage.draw(moment));
        const std::string file = std::string(s.name) + ".png";
        if (std::getenv("SAGARA_WRITE_GOLDEN") != nullptr) {
            ASSERT_FALSE(writePng(*view->latest(), golden / file));
            continue;
        }
        const auto kept = readOwnPng(golden / file);
        ASSERT_TRUE(kept) << file;
        const double off = difference(*kept, *view->latest());
        if (off > kTolerance) {
            fs::create_directories(found);
            (void)writePng(*view->latest(), found / file);
        }
        EXPECT_LE(off, kTolerance) << "now: " << (found / file).string();
    }
}

TEST(Golden, AStageCanBeOpenedAgainAfterTheFirstHasGone) {
    const auto world = test::lessonWorld();
    const Moment moment = momentOf(core::view(*world, core::startState(*world, 3)));
    std::vector<std::uint8_t> before;
    for (int round = 0; round < 2; ++round) {
        auto opened = Stage::open({SAGARA_ASSETS, Preset::Low, true});
        ASSERT_TRUE(opened) << opened.error();
        ASSERT_FALSE((**opened).show(world));
        const auto view = (*opened)->addViewport(64, 36);
        view->setCamera(bridgeCamera(*world, moment, 0, 0.0, Lens::symmetric(1.0, 64, 36)));
        ASSERT_FALSE((*opened)->draw(moment));
        EXPECT_TRUE(round == 0 || view->latest()->bgra == before);
        before = view->latest()->bgra;
    }
}

}  // namespace
}  // namespace sagara::render
