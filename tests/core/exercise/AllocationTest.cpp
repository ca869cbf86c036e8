#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "core/exercise/Advance.h"
#include "tests/support/exercise/Lesson.h"

// This test program counts what is allocated. GCC 12 takes our own pair of new and delete for two strangers.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size) {
    ++allocations;
    if (void* p = std::malloc(size)) return p;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size);
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace sagara::core {
namespace {

/// Allocations of all ticks of 20 s in which nothing happens; there must be many such ticks.
long allocationsIn(const World& world, State state) {
    long allocated = 0;
    int steady = 0;
    for (int i = 0; i < 1000; ++i) {
        const long before = allocations;
        const bool quiet = advance(world, state).empty();
        const long inTick = allocations - before;
        if (quiet) ++steady, allocated += inTick;
    }
    EXPECT_GT(steady, 950);
    return allocated;
}

TEST(Allocation, ASteadyTickAtTheBerthAllocatesNothing) {
    const auto world = test::lessonWorld();
    EXPECT_EQ(allocationsIn(*world, startState(*world, 1)), 0);
}

TEST(Allocation, ASteadyTickUnderWayWith2OwnShipsAnd20TargetsAllocatesNothing) {
    const auto world = test::worldOf(test::openWaterScenario(2, 20));
    EXPECT_EQ(allocationsIn(*world, startState(*world, 3)), 0);
}

}  // namespace
}  // namespace sagara::core
