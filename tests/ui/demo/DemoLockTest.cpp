#include "ui/demo/DemoLock.h"

#include <gtest/gtest.h>

namespace sagara::ui {
namespace {

bool typeAll(DemoLock& lock, const char* digits) {
    bool right = false;
    for (; *digits != '\0'; ++digits) right = lock.type(*digits);
    return right;
}

TEST(DemoLock, OpensToItsPinOnly) {
    DemoLock lock("4711");
    EXPECT_FALSE(typeAll(lock, "4711")) << "closed: nothing is taken";
    lock.open();
    EXPECT_TRUE(typeAll(lock, "4711"));
}

TEST(DemoLock, AWrongPinWaitsLongerEachTime) {
    DemoLock lock("1234");
    lock.open();
    double expected_s = DemoLock::kFirstWait_s;
    for (int i = 0; i < 3; ++i) {
        EXPECT_FALSE(typeAll(lock, "9999"));
        EXPECT_TRUE(lock.wasWrong());
        EXPECT_DOUBLE_EQ(lock.waits_s(), expected_s);
        EXPECT_FALSE(typeAll(lock, "1234")) << "nothing is taken while it waits";
        EXPECT_EQ(lock.typed(), 0u);
        lock.advance(expected_s);
        expected_s *= 2.0;
    }
    EXPECT_TRUE(typeAll(lock, "1234"));
    EXPECT_FALSE(lock.wasWrong());
}

TEST(DemoLock, NeverWaitsMoreThanAMinute) {
    DemoLock lock("1");
    for (int i = 0; i < 12; ++i) {
        lock.open();
        lock.type('2');
        EXPECT_LE(lock.waits_s(), DemoLock::kLongestWait_s);
        lock.advance(lock.waits_s());
    }
}

TEST(DemoLock, ClosesWhenLeftAloneAndForgetsWhatWasTyped) {
    DemoLock lock("1234");
    lock.open();
    typeAll(lock, "12");
    lock.advance(DemoLock::kClosesAfter_s);
    EXPECT_FALSE(lock.isOpen());
    lock.open();
    EXPECT_FALSE(typeAll(lock, "34"));
    EXPECT_EQ(lock.typed(), 2u);
    lock.erase();
    EXPECT_EQ(lock.typed(), 1u);
}

TEST(DemoLock, APinThatIsNoneIsFourNoughts) {
    for (const char* bad : {"", "12a4", "123456789"}) {
        DemoLock lock(bad);
        lock.open();
        EXPECT_TRUE(typeAll(lock, "0000")) << bad;
    }
}

}  // namespace
}  // namespace sagara::ui
