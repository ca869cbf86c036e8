#include "db/SeakeepingRepository.h"

#include <gtest/gtest.h>

#include "Support.h"

namespace sagara::db {
namespace {

using namespace test;

class Seakeeping : public ::testing::Test {
protected:
    TemporaryFolder m_folder;
    Database m_db{m_folder / "sagara.db"};
    SeakeepingRepository m_kept{m_db};
};

TEST_F(Seakeeping, GivesBackTheVeryBytesUnderTheirHash) {
    const std::string bytes("\0\xff\x80 tables", 10);
    m_kept.keep(0xfedcba9876543210, bytes);
    EXPECT_EQ(m_kept.find(0xfedcba9876543210), bytes);
    EXPECT_EQ(m_kept.find(1), std::nullopt);
    m_kept.keep(0xfedcba9876543210, "others");
    EXPECT_EQ(m_kept.find(0xfedcba9876543210), "others");
}

TEST_F(Seakeeping, TheOldestGo) {
    for (int i = 0; i <= SeakeepingRepository::kMost; ++i) m_kept.keep(static_cast<std::uint64_t>(i), "t");
    EXPECT_EQ(m_kept.find(0), std::nullopt);
    EXPECT_TRUE(m_kept.find(1));
    EXPECT_TRUE(m_kept.find(SeakeepingRepository::kMost));
}

}  // namespace
}  // namespace sagara::db
