#include "db/SettingRepository.h"

#include <gtest/gtest.h>

#include "Support.h"

namespace sagara::db {
namespace {

using namespace test;

class Settings : public ::testing::Test {
protected:
    TemporaryFolder m_folder;
    Database m_db{m_folder / "sagara.db"};
    SettingRepository m_settings{m_db};
};

TEST_F(Settings, LastValueCounts) {
    EXPECT_FALSE(m_settings.find("language"));
    m_settings.put("language", "en");
    m_settings.put("language", "ta");
    EXPECT_EQ(m_settings.find("language"), "ta");
}

TEST_F(Settings, EmptyValueIsAValue) {
    m_settings.put("motto", "");
    EXPECT_EQ(m_settings.find("motto"), "");
    m_settings.put("motto", std::string_view());
    EXPECT_EQ(m_settings.find("motto"), "");
}

TEST_F(Settings, AllAreListedAndRemovedOnesAreNot) {
    m_settings.put("a", "1");
    m_settings.put("b'; DROP TABLE setting; --", "'2'");
    m_settings.put("c", "3");
    m_settings.remove("a");
    m_settings.remove("never there");
    const std::map<std::string, std::string> expected{{"b'; DROP TABLE setting; --", "'2'"}, {"c", "3"}};
    EXPECT_EQ(m_settings.all(), expected);
}

}  // namespace
}  // namespace sagara::db
