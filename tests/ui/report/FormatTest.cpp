#include "ui/report/Format.h"

#include <gtest/gtest.h>

#include <limits>

namespace sagara::report {
namespace {

std::string of(const QString& text) { return text.toStdString(); }
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(ReportFormat, TimesCountMinutesPastTheHour) {
    EXPECT_EQ(of(clockTime(0.0)), "00:00");
    EXPECT_EQ(of(clockTime(425.0)), "07:05");
    EXPECT_EQ(of(clockTime(59.6)), "01:00");
    EXPECT_EQ(of(clockTime(6061.0)), "101:01");
    EXPECT_EQ(of(clockTime(kNan)), "–");
}

TEST(ReportFormat, LocalTimeNamesItsZoneAndOffset) {
    const core::Utc start = *core::parseUtc("2027-01-15T03:30:00Z");
    EXPECT_EQ(of(localTime(start, 330, "Asia/Colombo")), "15 January 2027, 09:00 (Asia/Colombo, UTC+05:30)");
    EXPECT_EQ(of(localTime(start, -210, "")), "15 January 2027, 00:00 (UTC−03:30)");
    EXPECT_EQ(of(utcTime(start)), "15 January 2027, 03:30 UTC");
    EXPECT_EQ(of(localDate(start, -240)), "14 January 2027");
}

DeductionLine deduction(const char* unit, double value, double limit) {
    DeductionLine line;
    line.unit = unit;
    line.value = value;
    line.limit = limit;
    return line;
}

TEST(ReportFormat, ADeductionHasTheDigitsOfItsUnit) {
    EXPECT_EQ(of(valueAndLimit(deduction("kn", 8.417, 6.0)).value), "8.4 kn");
    EXPECT_EQ(of(valueAndLimit(deduction("M", 0.02741, 0.02)).value), "0.027 M");
    EXPECT_EQ(of(valueAndLimit(deduction("m/s", 0.2312, 0.15)).limit), "0.15 m/s");
    EXPECT_EQ(of(valueAndLimit(deduction("m", 212.3, 463.0)).value), "212 m");
    EXPECT_EQ(of(valueAndLimit(deduction("", 1.0, 0.0)).value), "1");
}

TEST(ReportFormat, AValueNeverReadsLikeTheLimitItBroke) {
    EXPECT_EQ(of(valueAndLimit(deduction("kn", 6.02, 6.0)).value), "6.02 kn");
    EXPECT_EQ(of(valueAndLimit(deduction("kn", 6.02, 6.0)).limit), "6.00 kn");
    EXPECT_EQ(of(valueAndLimit(deduction("kn", 6.0, 6.0)).value), "6.0 kn") << "it is the limit";
}

TEST(ReportFormat, NumbersInARowAreJoined) {
    EXPECT_EQ(of(ranges({1})), "1");
    EXPECT_EQ(of(ranges({1, 2})), "1, 2");
    EXPECT_EQ(of(ranges({1, 2, 3, 7, 9, 10, 11, 12})), "1–3, 7, 9–12");
    EXPECT_EQ(of(ranges({})), "");
}

}  // namespace
}  // namespace sagara::report
