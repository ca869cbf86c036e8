#include "ui/input/NmeaOrders.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "ui/input/ControlMap.h"

namespace sagara::ui {
namespace {

core::Result<std::optional<NmeaOrder>, std::string> read(const std::string& body) {
    return orderOf(*parseSentence(withChecksum(body)));
}
template <typename Order>
const Order* orderIn(const core::Result<std::optional<NmeaOrder>, std::string>& answer) {
    return answer && answer->has_value() ? std::get_if<Order>(&**answer) : nullptr;
}

TEST(NmeaOrders, RudderOrderIsToStarboardWhenPositive) {
    const auto answer = read("AGROR,12.5,A,,V,B");
    ASSERT_NE(orderIn<NmeaRudder>(answer), nullptr);
    EXPECT_NEAR(orderIn<NmeaRudder>(answer)->rudder_rad, 12.5 * core::kDegree_rad, 1e-12);
    EXPECT_FALSE(read("AGROR,12.5,V,,V,B")->has_value());  // not valid: no order
    EXPECT_EQ(read("AGROR,hard,A").error(), "ROR: rudder order is \"hard\", expected -90 to 90 degrees");
    EXPECT_FALSE(read("AGROR,91,A"));
}

TEST(NmeaOrders, HeadingControlCommandsTheRudderOnlyByHand) {
    const auto answer = read("AGHTC,V,10.0,L,M,N,,,,,,,,T");
    ASSERT_NE(orderIn<NmeaRudder>(answer), nullptr);
    EXPECT_NEAR(orderIn<NmeaRudder>(answer)->rudder_rad, -10.0 * core::kDegree_rad, 1e-12);
    EXPECT_FALSE(read("AGHTC,V,10.0,L,S,N,,,,,,,,T")->has_value());
    EXPECT_FALSE(read("AGHTC,A,10.0,X,M"));
}

TEST(NmeaOrders, TelegraphOrdersAndNotAnswersAreTaken) {
    const auto answer = read("ERETL,120000.00,O,12,20,B,2");
    ASSERT_NE(orderIn<NmeaTelegraph>(answer), nullptr);
    EXPECT_EQ(orderIn<NmeaTelegraph>(answer)->step, core::TelegraphStep::SlowAstern);
    EXPECT_EQ(orderIn<NmeaTelegraph>(answer)->engine, 2);
    EXPECT_FALSE(read("ERETL,120000.00,A,12,20,B,2")->has_value());
    EXPECT_EQ(read("ERETL,,O,07,,B,0").error(),
              "ETL: telegraph position is \"07\", expected 00 to 05 or 11 to 15");
}

TEST(NmeaOrders, LeversAndThrustersAreInPerCent) {
    const auto lever = read("ERPRC,-50,A,,V,,V,B,1");
    ASSERT_NE(orderIn<NmeaLever>(lever), nullptr);
    EXPECT_EQ(orderIn<NmeaLever>(lever)->lever, -0.5);
    const auto thruster = read("IITRC,1,-40.0,P,,V,,B,C");
    ASSERT_NE(orderIn<NmeaThruster>(thruster), nullptr);
    EXPECT_EQ(orderIn<NmeaThruster>(thruster)->thrust, -0.4);
    const auto pitch = read("IITRC,1,,V,25,P,,B,C");
    ASSERT_NE(orderIn<NmeaThruster>(pitch), nullptr);
    EXPECT_EQ(orderIn<NmeaThruster>(pitch)->thrust, 0.25);
    EXPECT_FALSE(orderIn<NmeaThruster>(thruster)->atStern);
    const auto stern = read("IITRC,2,-40.0,P,,V,,B,C");
    ASSERT_NE(orderIn<NmeaThruster>(stern), nullptr);
    EXPECT_TRUE(orderIn<NmeaThruster>(stern)->atStern);
    EXPECT_FALSE(read("IITRC,1,-40.0,R,,V,,B,C"));  // rpm of what?
}

TEST(NmeaOrders, OwnSentencesFillTheGaps) {
    const auto horn = read("PSGR,HORN,1");
    ASSERT_NE(orderIn<NmeaHorn>(horn), nullptr);
    EXPECT_TRUE(orderIn<NmeaHorn>(horn)->on);
    EXPECT_NE(orderIn<NmeaAcknowledge>(read("PSGR,ACK")), nullptr);
    EXPECT_NE(orderIn<NmeaBookmark>(read("PSGR,BOOKMARK")), nullptr);
    EXPECT_NE(orderIn<NmeaLook>(read("PSGR,LOOK,-15")), nullptr);
    EXPECT_EQ(read("PSGR,FIRE").error(), "SGR: order is \"FIRE\", expected HORN, LOOK, ACK or BOOKMARK");
    EXPECT_FALSE(read("PGRME,1,2,3")->has_value());
}

TEST(NmeaOrders, SensorsAreNoOrders) {
    for (const char* body : {"IIHDT,123.4,T", "IIRSA,5.0,A,,V", "IIRPM,S,0,100,,A"})
        EXPECT_FALSE(read(body)->has_value()) << body;
}

TEST(NmeaOrders, EnginesAreNumberedFromTheCentreLine) {
    EXPECT_EQ(shaftOfEngine(0, 1), 0);
    EXPECT_EQ(shaftOfEngine(1, 1), 0);
    EXPECT_EQ(shaftOfEngine(0, 2), kEveryShaft);
    EXPECT_EQ(shaftOfEngine(1, 2), 1);
    EXPECT_EQ(shaftOfEngine(2, 2), 0);
    EXPECT_FALSE(shaftOfEngine(3, 2));
    EXPECT_FALSE(shaftOfEngine(5, 0));
    for (int shafts = 1; shafts <= 4; ++shafts)
        for (int shaft = 0; shaft < shafts; ++shaft)
            EXPECT_EQ(shaftOfEngine(engineOfShaft(shaft, shafts), shafts), shaft) << shafts;
}

}  // namespace
}  // namespace sagara::ui
