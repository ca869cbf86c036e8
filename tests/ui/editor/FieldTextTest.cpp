#include "ui/editor/FieldText.h"

#include <gtest/gtest.h>

namespace sagara::ui::editor {
namespace {

void expectPlace(const char* text, double lat_deg, double lon_deg) {
    const auto place = typedPosition(QString::fromUtf8(text));
    ASSERT_TRUE(place) << text;
    EXPECT_NEAR(place->lat_deg, lat_deg, 1e-9) << text;
    EXPECT_NEAR(place->lon_deg, lon_deg, 1e-9) << text;
}

TEST(EditorPosition, IsReadAsPeopleWriteIt) {
    expectPlace("6.03225, 80.2302", 6.03225, 80.2302);
    expectPlace("-6.5 -80.25", -6.5, -80.25);
    expectPlace("006°01.935'N 080°13.812'E", 6.03225, 80.2302);
    expectPlace("6 1.935 s, 80 13.812 w", -6.03225, -80.2302);
    expectPlace("6.5N 80.25E", 6.5, 80.25);
    for (const char* bad : {"", "6", "6 61 N 80 0 E", "91, 0", "0, 181", "north", "6 1.9 N", "6 1 E 80 2 N"})
        EXPECT_FALSE(typedPosition(QString::fromUtf8(bad))) << bad;
}

TEST(EditorPosition, IsShownSoThatItReadsBackWithinAMetre) {
    const core::GeoPoint place{6.007185, 80.227506};
    const auto again = typedPosition(positionText(place));
    ASSERT_TRUE(again);
    EXPECT_NEAR(again->lat_deg, place.lat_deg, 1e-6);
    EXPECT_NEAR(again->lon_deg, place.lon_deg, 1e-6);
}

TEST(EditorNumber, KeepsWholeNumbersWholeAndRefusesWords) {
    const Field field = number("n", {}, 0, 120, QStringLiteral("kn"), {}, 0);
    EXPECT_EQ(typed(field, QStringLiteral(" 12 "))->dump(), "12");
    EXPECT_EQ(typed(field, QStringLiteral("8,5"))->dump(), "8.5");
    for (const char* bad : {"", "abc", "1.2.3", "nan", "inf"}) EXPECT_FALSE(typed(field, QString::fromUtf8(bad))) << bad;
    EXPECT_FALSE(typed(integer("i", {}, 1, 5, {}, 1), QStringLiteral("2.5")));
    EXPECT_EQ(accepted(field), QStringLiteral("0 to 120 kn"));
    const Json value = 0.12;
    EXPECT_EQ(shown(field, &value), QStringLiteral("0.12"));
}

TEST(EditorId, IsOneOrRefused) {
    EXPECT_TRUE(typed(idField({}), QStringLiteral("head-line-2")));
    EXPECT_FALSE(typed(idField({}), QStringLiteral("Head Line")));
}

}  // namespace
}  // namespace sagara::ui::editor
