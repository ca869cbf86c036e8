#include "core/base/Utc.h"

#include <gtest/gtest.h>

namespace sagara::core {
namespace {

TEST(Utc, ReadsAndWritesTheSameInstant) {
    const auto start = parseUtc("2027-01-15T03:30:00Z");
    ASSERT_TRUE(start);
    EXPECT_EQ(start->unix_s, 1'799'983'800);
    EXPECT_EQ(formatUtc(*start), "2027-01-15T03:30:00Z");
    EXPECT_EQ(formatLocal(*start, 330), "2027-01-15 09:00:00");
}

TEST(Utc, RefusesWhatIsNotAnInstant) {
    for (const char* text :
         {"", "2027-01-15", "2027-13-15T03:30:00Z", "2027-02-29T00:00:00Z", "2027-01-15T24:00:00Z",
          "2027-01-15 03:30:00Z", "2027-01-15T03:30:0xZ", "2027-01-15T03:30:00+"}) {
        EXPECT_FALSE(parseUtc(text)) << text;
    }
}

TEST(Utc, J2000IsNoonOfTheFirstOfJanuary2000) {
    EXPECT_EQ(daysSinceJ2000(*parseUtc("2000-01-01T12:00:00Z")), 0.0);
    EXPECT_EQ(daysSinceJ2000(*parseUtc("2000-01-02T00:00:00Z")), 0.5);
}

}  // namespace
}  // namespace sagara::core
