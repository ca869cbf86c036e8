#include "app/run/PrepareHulls.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "app/run/DatabaseTables.h"
#include "core/seakeeping/MakeTables.h"
#include "core/vessel/Vessel.h"
#include "db/DocumentRepository.h"

namespace sagara::run {
namespace {

/// Of the shipped vessels those whose tables are in the database.
int preparedOf(const Store& store) {
    DatabaseTables kept(store.folder().database());
    int count = 0;
    for (const auto& entry : db::DocumentRepository(*store.database(), db::DocumentTable::Vessel).inUse()) {
        const auto vessel =
            core::loadVessel(entry.key, *store.find(core::DocumentKind::Vessel, entry.key)).value();
        if (kept.find(core::tablesHash(core::hullFormOf(vessel.hull), {}))) ++count;
    }
    return count;
}

TEST(PrepareHulls, MakesTablesThatAreNotThereAndEndsWhenItIsTold) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "sagara-prepare-hulls-test";
    std::filesystem::remove_all(folder);
    auto opened = Store::open(folder);
    ASSERT_TRUE(opened) << opened.error();
    const Store& store = **opened;
    ASSERT_NE(store.database(), nullptr);
    EXPECT_EQ(preparedOf(store), 0);
    const auto until = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    {
        const PrepareHulls preparing(store);
        while (preparedOf(store) < 2 && std::chrono::steady_clock::now() < until)
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
    const int prepared = preparedOf(store);
    EXPECT_GE(prepared, 2);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    EXPECT_EQ(preparedOf(store), prepared);  // nobody works on
    {
        const PrepareHulls again(store);  // goes on with the next
        while (preparedOf(store) <= prepared && std::chrono::steady_clock::now() < until)
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
    EXPECT_GT(preparedOf(store), prepared);
    opened = std::string();
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace sagara::run
