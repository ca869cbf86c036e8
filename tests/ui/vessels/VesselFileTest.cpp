#include "ui/vessels/VesselFile.h"

#include <gtest/gtest.h>

#include "core/vessel/Vessel.h"
#include "tests/support/Assets.h"
#include "ui/vessels/FieldNames.h"

namespace sagara::ui {
namespace {

const std::string kPatrol = test::readAsset("vessels/patrol51.json");

TEST(VesselFile, ComesBackWithItsFiles) {
    const std::string bytes("\0\xff\x7fmodel", 8);
    const std::string text = vesselFileText({kPatrol, {{"attached/patrol51/a.ac", bytes}}});
    const auto file = readVesselFile("export.json", text);
    ASSERT_TRUE(file) << file.error();
    ASSERT_EQ(file->files.size(), 1u);
    EXPECT_EQ(file->files[0].path, "attached/patrol51/a.ac");
    EXPECT_EQ(file->files[0].bytes, bytes);
    EXPECT_EQ(core::loadVessel("x", file->text).value().id, "patrol51");
}

TEST(VesselFile, ABareDocumentIsReadToo) {
    const auto file = readVesselFile("patrol51.json", kPatrol);
    ASSERT_TRUE(file);
    EXPECT_TRUE(file->files.empty());
}

TEST(VesselFile, RefusesWhatWouldLeaveTheFolderAndWhatIsNoVessel) {
    for (const char* path : {"../outside", "/etc/passwd", "a/../../b", "c:\\x"}) {
        const auto file = readVesselFile("bad.json", vesselFileText({kPatrol, {{path, "x"}}}));
        ASSERT_FALSE(file) << path;
        EXPECT_TRUE(file.error().starts_with("bad.json: files")) << file.error();
    }
    EXPECT_FALSE(readVesselFile("bad.json", "{}"));
    EXPECT_FALSE(readVesselFile("bad.json", "not json"));
    EXPECT_FALSE(readVesselFile("bad.json", R"({"document": "vessel-export", "version": 9})"));
}

TEST(FieldNames, ReadLikeWordsWithTheirUnit) {
    EXPECT_EQ(fieldName("lengthBp_m").label, QStringLiteral("Length between perpendiculars"));
    EXPECT_EQ(fieldName("rate_degps").unit, QStringLiteral("°/s"));
    EXPECT_EQ(fieldName("rudderYawLever_m").label, QStringLiteral("Rudder yaw lever"));
    EXPECT_EQ(fieldName("liftSlope_perDeg").unit, QStringLiteral("1/°"));
}

}  // namespace
}  // namespace sagara::ui
