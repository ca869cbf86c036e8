#include "app/run/CommandDelay.h"

#include <gtest/gtest.h>

namespace sagara::run {
namespace {

TEST(CommandDelay, CountsFromTheOrderToTheLastChannelOfTheFirstFrameThatShowsIt) {
    CommandDelay d;
    d.given(1'000'000);
    EXPECT_TRUE(d.waiting());
    d.sent(7, {500'000});  // not carried out yet
    d.carriedOut({520'000});
    d.sent(8, {510'000});  // still the moment before
    d.sent(9, {530'000});
    d.shown(8, 1'040'000);
    d.frameOver(8);
    EXPECT_TRUE(d.waiting());
    d.shown(9, 1'080'000);
    d.shown(9, 1'083'000);
    d.sent(10, {570'000});
    d.frameOver(9);
    EXPECT_FALSE(d.waiting());
    EXPECT_EQ(d.text(), "1 orders, seen on all channels after 83 ms, p95 83, most 83");
}

TEST(CommandDelay, AFrameNobodyShowedIsNoDelay) {
    CommandDelay d;
    d.given(0);
    d.carriedOut({20'000});
    d.sent(2, {20'000});
    d.frameOver(2);
    EXPECT_EQ(d.count(), 0u);
    EXPECT_FALSE(d.waiting());
}

}  // namespace
}  // namespace sagara::run
