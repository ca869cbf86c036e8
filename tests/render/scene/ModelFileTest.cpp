#include "render/scene/ship/ModelFile.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "ShapeExtent.h"
#include "render/scene/Picture.h"
#include "render/scene/ship/Fleet.h"
#include "tests/support/Assets.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::render {
namespace {

namespace fs = std::filesystem;

/// A hull from x -4 (her bow) to 6 in the file, 1 m either side of her centreline, y from -1 to 1; a mast of
/// one triangle amidships and to port, 3 m high; a wake far astern.
constexpr const char* kBarge = R"(
mtllib barge.mtl
v -4 -1 0
v 6 -1 -1
v 6 -1 1
v 6 1 -1
v 6 1 1
v -4 1 0
v 0 1 0.5
v 1 1 0.5
v 0 3 0.5
v 40 0 -9
v 40 0 9
v 6 0 0
vt 0 0
vt 1 0
vt 0 1
o Hull
usemtl blue
f 1 2 3
f 6 4 5
o Mast
usemtl checked
f 7/1 8/2 9/3
o Wake
usemtl blue
f 10 11 12
)";
constexpr const char* kMaterials = R"(
newmtl blue
Kd 0.1 0.2 0.8
newmtl checked
Kd 1 1 1
map_Kd C:\work\checked.png
)";

class ModelFile : public ::testing::Test {
protected:
    ModelFile() : folder(fs::temp_directory_path() / ("sagara-model-" + std::to_string(::getpid()))) {
        fs::create_directories(folder);
        write("barge.obj", kBarge);
        write("barge.mtl", kMaterials);
        // Red on the left, white on the right.
        render::Picture image{4, 2, std::vector<std::uint8_t>(32, 255)};
        for (const std::size_t left : {0u, 1u, 4u, 5u}) image.bgra[4 * left] = image.bgra[4 * left + 1] = 0;
        EXPECT_FALSE(writePng(image, folder / "checked.png"));
        barge.model = "barge.obj";
        barge.forward = {0, -1};
        barge.up = {1, 1};
        barge.fit = core::Picture::Fit::Length;
        barge.leaveOut = {"Wake"};
        barge.aroundBridge = {"M*t"};
    }
    ~ModelFile() override { fs::remove_all(folder); }
    void write(const char* name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
    }
    core::Result<ShipModel, std::string> read(double length_m = 20.0, double beam_m = 6.0) const {
        return readModel(folder, barge, length_m, beam_m);
    }
    std::string troubleOf(const char* model, const std::string& text) {
        write(model, text);
        barge.model = model;
        const auto read_ = read();
        return read_ ? "" : read_.error();
    }

    fs::path folder;
    core::Picture barge;
};

TEST_F(ModelFile, IsTurnedAndFittedToTheLengthOfTheShip) {
    barge.waterline_m = 0.5;
    const auto model = read();
    ASSERT_TRUE(model) << model.error();
    const Extent hull = extentOf(model->shape.hull);  // ten metres become twenty
    EXPECT_NEAR(hull.low.x, -10.0, 1e-5);
    EXPECT_NEAR(hull.high.x, 10.0, 1e-5);
    EXPECT_NEAR(hull.high.y, 2.0, 1e-5);
    EXPECT_NEAR(hull.low.up, -3.0, 1e-5);
    EXPECT_NEAR(hull.high.up, 1.0, 1e-5);
    // The bow is the one point at x -4.
    for (const SolidVertex& v : model->shape.hull.vertices)
        EXPECT_EQ(v.position.x > 0.0, v.position.y == 0.0);
    // z is to port where -x is ahead and y up.
    ASSERT_EQ(model->shape.textured.upperworks.size(), 1u);
    const Extent mast = extentOf(model->shape.textured.upperworks[0].solid);
    EXPECT_NEAR(mast.high.y, -1.0, 1e-5);
    EXPECT_NEAR(mast.high.up, 5.0, 1e-5);
}

TEST_F(ModelFile, IsFittedToTheBeamOrScaledWhereThatIsAsked) {
    barge.fit = core::Picture::Fit::LengthAndBeam;
    const Extent fitted = extentOf(read()->shape.hull);
    EXPECT_NEAR(fitted.high.x - fitted.low.x, 20.0, 1e-5);
    EXPECT_NEAR(fitted.high.y - fitted.low.y, 6.0, 1e-5);
    EXPECT_NEAR(fitted.high.up - fitted.low.up, 6.0, 1e-5);
    barge.fit = core::Picture::Fit::Scale;
    barge.scale = 3.0;
    barge.midship_m = 4.0;  // the bow
    const Extent scaled = extentOf(read()->shape.hull);
    EXPECT_NEAR(scaled.high.x, 0.0, 1e-5);
    EXPECT_NEAR(scaled.low.x, -30.0, 1e-5);
}

TEST_F(ModelFile, PutsObjectsWhereTheDocumentSays) {
    const auto model = read();
    EXPECT_EQ(model->shape.hull.triangles(), 2u);
    EXPECT_EQ(model->shape.textured.upperworks[0].solid.triangles(), 1u);
    barge.detail = {"Mast"};
    barge.leaveOut.clear();
    const auto other = read();
    EXPECT_EQ(other->shape.hull.triangles(), 3u);
    EXPECT_TRUE(other->shape.textured.upperworks.empty());
    EXPECT_EQ(other->shape.textured.detail[0].solid.triangles(), 1u);
}

TEST_F(ModelFile, HasTexturesTheRightWayUpAndColours) {
    const auto model = read();
    const TexturedSolid& mast = model->shape.textured.upperworks[0];
    EXPECT_EQ(mast.texture->width, 4);
    EXPECT_EQ(mast.texture->abgr[0], 0xff0000ffu);
    EXPECT_EQ(mast.texture->abgr[3], 0xffffffffu);
    for (std::size_t i = 0; i < 3; ++i)  // the top of the mast is the top row of the texture
        EXPECT_EQ(mast.solid.vertices[i].position.up > 3.0, mast.places[i][1] < 0.5f);
    EXPECT_NEAR(model->shape.hull.vertices[0].colour.blue, 0.8, 1e-6);
}

TEST_F(ModelFile, ATextureOfOneColourIsAColour) {
    EXPECT_FALSE(writePng({2, 2, std::vector<std::uint8_t>(16, 51)}, folder / "checked.png"));
    const auto model = read();
    EXPECT_TRUE(model->shape.textured.upperworks.empty());
    EXPECT_NEAR(model->shape.upperworks.vertices[0].colour.red, 0.2, 1e-6);
}

TEST_F(ModelFile, IsPaintedAsTheDocumentSays) {
    barge.paints = {{{"Hull"}, std::array{0.5, 0.25, 0.0}, true}, {{"*"}, std::nullopt, false}};
    const auto model = read();
    EXPECT_EQ(model->shape.hull.vertices[0].colour.red, 0.5);
    EXPECT_TRUE(model->shape.textured.upperworks.empty());  // the mast has lost its texture
    EXPECT_EQ(model->shape.upperworks.vertices[0].colour.red, 1.0);
}

TEST_F(ModelFile, BringsItsLightsToTheShip) {
    barge.waterline_m = 0.5;
    barge.lights[static_cast<std::size_t>(core::LightPlace::Port)] = {1.0, -0.5, 2.0};
    const auto port = read()->lights[static_cast<std::size_t>(core::LightPlace::Port)];
    ASSERT_TRUE(port);
    EXPECT_NEAR(port->x, 2.0, 1e-6);
    EXPECT_NEAR(port->y, -1.0, 1e-6);
    EXPECT_NEAR(port->up, 4.0, 1e-6);
}

TEST_F(ModelFile, WhatIsBrokenIsToldWithTheFile) {
    const std::string begin = "model " + folder.string() + "/";
    barge.model = "none.ac";
    EXPECT_EQ(read().error(), begin + "none.ac is not there or empty");
    EXPECT_EQ(troubleOf("empty.ac", ""), begin + "empty.ac is not there or empty");
    EXPECT_EQ(troubleOf("noise.ac", std::string(500, 'x')).rfind(begin + "noise.ac cannot be read: ", 0), 0u);
    EXPECT_EQ(troubleOf("x.txt", "hello").rfind(begin + "x.txt cannot be read: ", 0), 0u);
    fs::remove(folder / "checked.png");
    EXPECT_EQ(troubleOf("barge.obj", kBarge).rfind(begin + "barge.obj names a texture ", 0), 0u);
    write("checked.png", "no picture");
    EXPECT_EQ(troubleOf("barge.obj", kBarge).rfind(begin + "barge.obj names a texture ", 0), 0u);
    barge.leaveOut = {"*"};
    EXPECT_EQ(troubleOf("barge.obj", kBarge), begin + "barge.obj has no triangles that are not left out");
}

TEST_F(ModelFile, WhatIsHugeIsRefused) {
    std::string many = "o Many\n";
    for (int i = 0; i < 210'000; ++i)
        many += "v " + std::to_string(i) + " " + std::to_string(i % 7) + " " + std::to_string(i % 3) + "\n";
    for (int i = 1; i + 2 <= 210'000; i += 3)
        many += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
    EXPECT_NE(troubleOf("many.obj", many).find("has more than 200000 vertices"), std::string::npos);
    write("big.obj", "x");
    fs::resize_file(folder / "big.obj", 40u << 20);
    barge.model = "big.obj";
    EXPECT_NE(read().error().find("has 41943040 bytes, expected at most 33554432"), std::string::npos);
    EXPECT_NE(troubleOf("counts.ac",
                        "AC3Db\nMATERIAL \"m\" rgb 1 1 1 amb 1 1 1 emis 0 0 0 spec 0 0 0 shi 0 trans 0\n"
                        "OBJECT world\nkids 1\nOBJECT poly\nnumvert 2000000000\n0 0 0\nkids 0\n"),
              "");
}

TEST_F(ModelFile, EveryTruncationOfAShippedModelIsAModelOrAnError) {
    const std::string whole = test::readAsset("models/flightgear/container_carrier.ac");
    fs::copy_file(SAGARA_ASSETS "/models/flightgear/container.png", folder / "container.png");
    fs::copy_file(SAGARA_ASSETS "/models/flightgear/saratoga.png", folder / "saratoga.png");
    int refused = 0, tried = 0;
    for (std::size_t length = 10; length < whole.size(); length += 397, ++tried)
        if (!troubleOf("cut.ac", whole.substr(0, length)).empty()) ++refused;
    EXPECT_GT(refused, tried / 2);
}

TEST_F(ModelFile, RandomDamageIsAModelOrAnError) {
    const std::string whole = test::readAsset("models/flightgear/container_carrier.ac");
    fs::copy_file(SAGARA_ASSETS "/models/flightgear/container.png", folder / "container.png");
    fs::copy_file(SAGARA_ASSETS "/models/flightgear/saratoga.png", folder / "saratoga.png");
    std::mt19937 random(20270115);
    for (int round = 0; round < 150; ++round) {
        std::string text = whole;
        for (int i = 0; i < 8; ++i) text[random() % text.size()] = static_cast<char>(random() % 256);
        (void)troubleOf("damaged.ac", text);
        // Numbers too large or negative where counts and indices are.
        text = whole;
        for (int i = 0; i < 4; ++i) {
            const std::size_t at = text.find_first_of("0123456789", random() % text.size());
            if (at != std::string::npos) text.replace(at, 1, i % 2 ? "-7" : "99999");
        }
        (void)troubleOf("damaged.ac", text);
    }
}

TEST(Names, StarsStandForAnyLetters) {
    EXPECT_TRUE(matches("Wake", "Wake"));
    EXPECT_FALSE(matches("Wake", "Wakes"));
    EXPECT_TRUE(matches("L_*Light*", "L_PortLight.001"));
    EXPECT_TRUE(matches("*", ""));
    EXPECT_TRUE(matches("a*b*c", "a1b2b3c"));
    EXPECT_FALSE(matches("a*b", "a1b2"));
    EXPECT_FALSE(matches("", "a"));
}

TEST(Pictures, EveryShippedOneIsAModelOfAFewThousandTriangles) {
    int pictures = 0;
    for (const auto& entry : fs::directory_iterator(SAGARA_ASSETS "/pictures")) {
        const std::string file = entry.path().string();
        const auto picture = core::loadPicture(file, test::readFile(file));
        ASSERT_TRUE(picture) << picture.error().text();
        const auto model = readModel(SAGARA_ASSETS "/models", *picture, 40.0, 8.0);
        ASSERT_TRUE(model) << model.error();
        const ShipShape& s = model->shape;
        std::size_t triangles = s.hull.triangles() + s.upperworks.triangles();
        for (const auto* list : {&s.textured.hull, &s.textured.upperworks})
            for (const TexturedSolid& t : *list) triangles += t.solid.triangles();
        EXPECT_LT(triangles, 6000u) << file;
        EXPECT_LE(s.textured.hull.size(), 2u) << file;  // each is a draw call
        Extent all = extentOf(s.hull);
        for (const TexturedSolid& t : s.textured.hull) {
            const Extent e = extentOf(t.solid);
            all = {{std::min(all.low.x, e.low.x), 0.0, std::min(all.low.up, e.low.up)},
                   {std::max(all.high.x, e.high.x), 0.0, 0.0}};
        }
        EXPECT_NEAR(all.high.x, 20.0, 1.0) << file;
        EXPECT_NEAR(all.low.x, -20.0, 3.5) << file;  // outboard engines are detail
        EXPECT_LT(all.low.up, 0.0) << file;          // afloat, not flying
        ++pictures;
    }
    EXPECT_GE(pictures, 6);
}

TEST(Fleet, AShipWithoutItsModelIsDrawnFromHerFormAndThatIsSaid) {
    const auto world = test::lessonWorld();
    const Fleet fleet = fleetOf(*world, SAGARA_ASSETS);
    EXPECT_TRUE(fleet.remarks.empty()) << fleet.remarks.front();
    const Fleet bare = fleetOf(*world, "/nowhere");
    ASSERT_EQ(bare.remarks.size(), 2u);
    EXPECT_EQ(bare.remarks[0],
              "yacht-1 is drawn without a model: picture /nowhere/pictures/yacht.json cannot be read");
    const auto yacht =
        static_cast<std::size_t>(std::find_if(world->targets.begin(), world->targets.end(),
                                              [](const core::TargetLayout& t) { return t.id == "yacht-1"; }) -
                                 world->targets.begin());
    const Solid plain = shapeOf(formOf(world->targets[yacht]), static_cast<unsigned>(yacht)).hull;
    EXPECT_EQ(bare.targets[yacht].shape.hull.triangles(), plain.triangles());
    EXPECT_FALSE(bare.targets[yacht].form.lights[0]);
    EXPECT_NE(fleet.targets[yacht].shape.hull.triangles(), plain.triangles());
    EXPECT_TRUE(fleet.targets[yacht].form.lights[0]);
}

}  // namespace
}  // namespace sagara::render
