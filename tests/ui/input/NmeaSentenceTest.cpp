#include "ui/input/NmeaSentence.h"

#include <gtest/gtest.h>

#include <random>

#include "ui/input/NmeaOrders.h"

namespace sagara::ui {
namespace {

TEST(NmeaSentence, RealLinesAreRead) {
    // SignalK samples/plaka.log (Apache-2.0).
    const auto wind = parseSentence("$IIMWV,338,R,13.41,N,A*2C");
    ASSERT_TRUE(wind);
    EXPECT_EQ(wind->talker, "II");
    EXPECT_EQ(wind->type, "MWV");
    ASSERT_EQ(wind->fields.size(), 5U);
    EXPECT_EQ(wind->field(2), "13.41");
    EXPECT_EQ(wind->field(9), "");
    const auto empty = parseSentence("$IIHDT,,T*0C");
    ASSERT_TRUE(empty);
    EXPECT_EQ(empty->field(0), "");
}

TEST(NmeaSentence, MalformedLinesSayWhy) {
    const auto fault = [](std::string_view line) {
        const auto parsed = parseSentence(line);
        return parsed ? std::optional<NmeaFault>() : std::optional<NmeaFault>(parsed.error());
    };
    EXPECT_EQ(fault("$IIHDT,,T*0D"), NmeaFault::WrongChecksum);
    EXPECT_EQ(fault("$IIHDT,,T"), NmeaFault::NoChecksum);
    EXPECT_EQ(fault("$IIHDT,,T*"), NmeaFault::NoChecksum);
    EXPECT_EQ(fault("$IIHDT,,T*0"), NmeaFault::NoChecksum);
    EXPECT_EQ(fault("$IIHDT,,T*GG"), NmeaFault::NoChecksum);
    EXPECT_EQ(fault("$IIHDT,,T*-1"), NmeaFault::NoChecksum);
    EXPECT_EQ(fault(""), NmeaFault::NotASentence);
    EXPECT_EQ(fault("hello world"), NmeaFault::NotASentence);
    EXPECT_EQ(fault(withChecksum("II")), NmeaFault::NotASentence);
    EXPECT_EQ(fault("$II\x01"), NmeaFault::NotText);
    EXPECT_EQ(fault(std::string(200, '$')), NmeaFault::TooLong);
}

TEST(NmeaSentence, ChecksumsAreThoseOfTheStandard) {
    EXPECT_EQ(withChecksum("IIHDT,,T"), "$IIHDT,,T*0C");
    EXPECT_EQ(withChecksum("IIDBT,034.25,f,010.44,M,005.64,F"), "$IIDBT,034.25,f,010.44,M,005.64,F*27");
}

TEST(NmeaSentence, EveryTruncationIsRefused) {
    const std::string whole = withChecksum("IIROR,-10.0,A,,V,B");
    for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_FALSE(parseSentence(whole.substr(0, i)));
    EXPECT_TRUE(parseSentence(whole));
}

TEST(NmeaSentence, RandomBytesGiveSentencesOrReasons) {
    std::mt19937 random(11);
    NmeaLines lines;
    std::size_t cut = 0;
    for (int i = 0; i < 10'000; ++i) {
        std::string bytes(random() % 300, '\0');
        for (char& c : bytes) c = static_cast<char>(random());
        for (const std::string& line : lines.feed(bytes)) {
            EXPECT_LE(line.size(), kLongestSentence + 1);
            const auto parsed = parseSentence(line);
            if (parsed) static_cast<void>(orderOf(*parsed));
            ++cut;
        }
    }
    EXPECT_GT(cut, 1000U);
}

TEST(NmeaSentence, RandomFieldsBehindARightChecksumNeverBreakAnOrder) {
    std::mt19937 random(13);
    const std::string types[] = {"IIROR", "IIHTC", "IIETL", "IIPRC", "IITRC", "PSGR"};
    const std::string scraps[] = {"",   "-10.0", "A", "V",    "1e308", "-nan", "inf",      "O",   "03",
                                  "99", "-1",    "P", "HORN", "LOOK",  "1",    "99999999", "0x3", "L"};
    for (int i = 0; i < 20'000; ++i) {
        std::string body = types[random() % std::size(types)];
        for (std::size_t k = random() % 10; k > 0; --k) body += "," + scraps[random() % std::size(scraps)];
        const auto parsed = parseSentence(withChecksum(body));
        ASSERT_TRUE(parsed) << body;
        const auto order = orderOf(*parsed);
        EXPECT_TRUE(order || !order.error().empty());
    }
}

TEST(NmeaLines, PiecesAreJoinedAndLongLinesCutOnce) {
    NmeaLines lines;
    EXPECT_TRUE(lines.feed("$IIHDT,").empty());
    const auto whole = lines.feed(",T*0C\r\n$II");
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_EQ(whole[0], "$IIHDT,,T*0C");
    EXPECT_EQ(lines.feed(std::string(5000, 'x')).size(), 1U);
    EXPECT_EQ(lines.feed("\n$IIHDT,,T*0C\n").size(), 1U);
}

}  // namespace
}  // namespace sagara::ui
