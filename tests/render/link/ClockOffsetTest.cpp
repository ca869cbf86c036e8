#include "render/link/ClockOffset.h"

#include <gtest/gtest.h>

#include <random>

namespace sagara::link {
namespace {

/// A ping that took `there_us` and `back_us` on the way to a clock that is so much ahead.
void exchange(ClockOffset& offset, std::int64_t at_us, std::int64_t ahead_us, std::int64_t there_us,
              std::int64_t back_us) {
    const std::int64_t received_us = at_us + there_us + ahead_us, answered_us = received_us + 15;
    offset.add({1, at_us, received_us, answered_us}, answered_us - ahead_us + back_us);
}

TEST(ClockOffset, ASymmetricPathGivesTheOffsetExactly) {
    for (const std::int64_t ahead_us : {0LL, 123'456LL, -7'000'000'000LL}) {
        ClockOffset offset;
        EXPECT_FALSE(offset.known());
        exchange(offset, 1'000'000, ahead_us, 80, 80);
        EXPECT_EQ(offset.ahead_us(), ahead_us);
        EXPECT_EQ(offset.delay_us(), 160);
        EXPECT_EQ(offset.toOurs_us(5'000 + ahead_us), 5'000);
    }
}

TEST(ClockOffset, TheErrorIsAtMostHalfTheLeastDelay) {
    ClockOffset offset;
    std::mt19937 random(3);
    std::int64_t least_us = 1'000'000;
    for (int i = 0; i < 16; ++i) {
        // A busy channel answers late: the delay is one-sided.
        const std::int64_t there_us = 50 + static_cast<std::int64_t>(random() % 40'000), back_us = 60;
        exchange(offset, 500'000 * i, 42'000, there_us, back_us);
        least_us = std::min(least_us, there_us + back_us);
    }
    EXPECT_EQ(offset.delay_us(), least_us);
    EXPECT_LE(std::abs(offset.ahead_us() - 42'000), least_us / 2);
}

TEST(ClockOffset, OldSamplesAreForgotten) {
    ClockOffset offset;
    exchange(offset, 0, 1'000, 10, 10);
    for (int i = 1; i <= 16; ++i) exchange(offset, 500'000 * i, 2'000, 100, 100);
    EXPECT_EQ(offset.ahead_us(), 2'000);
}

TEST(ClockOffset, AnAnswerBeforeTheQuestionIsDropped) {
    ClockOffset offset;
    offset.add({1, 1000, 5000, 4000}, 2000);
    offset.add({1, 1000, 5000, 9000}, 2000);
    EXPECT_FALSE(offset.known());
    EXPECT_EQ(offset.ahead_us(), 0);
}

}  // namespace
}  // namespace sagara::link
