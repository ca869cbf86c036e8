#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "Support.h"
#include "db/SettingRepository.h"
#include "db/Transaction.h"

namespace sagara::db {
namespace {

using namespace test;

/// Two rows that are equal at every commit, with a document that makes the log grow.
void writePair(Database& db, int value) {
    Transaction transaction(db);
    SettingRepository(db).put("left", std::to_string(value));
    DocumentRepository(db, DocumentTable::Vessel)
        .put(patrol(std::string(20'000, 'a') + std::to_string(value)), kMorning);
    SettingRepository(db).put("right", std::to_string(value));
    transaction.commit();
}

TEST(Threads, BackupsMadeWhileAnotherThreadWritesAreEachOfOneInstant) {
    const TemporaryFolder folder;
    Database db(folder / "sagara.db");
    writePair(db, 0);
    std::atomic<bool> stop = false;
    std::atomic<int> written = 0;
    std::thread writer([&] {
        Database own(folder / "sagara.db");
        while (!stop) writePair(own, ++written);
    });
    for (int i = 0; i < 5; ++i) {
        const int before = written;
        while (written < before + 3) std::this_thread::yield();
        const auto copy = folder / ("copy" + std::to_string(i));
        db.backupTo(copy);
        Database backup(copy);
        EXPECT_TRUE(backup.integrity().empty());
        EXPECT_EQ(SettingRepository(backup).find("left"), SettingRepository(backup).find("right"));
    }
    stop = true;
    writer.join();
    EXPECT_TRUE(db.integrity().empty());
}

TEST(Threads, EachWithItsOwnDatabaseWriteSideBySide) {
    constexpr int kThreads = 2, kRuns = 100;
    const TemporaryFolder folder;
    const auto work = [&folder](int thread) {
        Database own(folder / "sagara.db");
        for (int i = 0; i < kRuns; ++i) {
            fileRun(own, {lesson(std::to_string(thread) + "/" + std::to_string(i)), ended(), good()});
        }
    };
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t) threads.emplace_back(work, t);
    for (std::thread& t : threads) t.join();
    Database db(folder / "sagara.db");
    EXPECT_EQ(RunRepository(db).count(), kThreads * kRuns);
    EXPECT_TRUE(db.integrity().empty());
}

TEST(Threads, ThatStartTogetherMakeOneNewDatabase) {
    constexpr int kThreads = 4;
    for (int round = 0; round < 10; ++round) {
        const TemporaryFolder folder;
        std::atomic<int> ready = 0;
        const auto work = [&](int thread) {
            ++ready;
            while (ready < kThreads) std::this_thread::yield();
            Database own(folder / "sagara.db");
            SettingRepository(own).put(std::to_string(thread), "here");
        };
        std::vector<std::thread> threads;
        for (int t = 0; t < kThreads; ++t) threads.emplace_back(work, t);
        for (std::thread& t : threads) t.join();
        {
            Database db(folder / "sagara.db");
            EXPECT_EQ(SettingRepository(db).all().size(), 4u);
        }
        EXPECT_EQ(contentsOf(folder.path()).size(), 1u);
    }
}

TEST(Threads, DatabaseMayMoveToNoOtherThreadYetManyMayLiveInOne) {
    const TemporaryFolder folder;
    std::vector<std::unique_ptr<Database>> many;
    for (int i = 0; i < 20; ++i) many.push_back(std::make_unique<Database>(folder / "sagara.db"));
    SettingRepository(*many.front()).put("a", "1");
    EXPECT_EQ(SettingRepository(*many.back()).find("a"), "1");
}

}  // namespace
}  // namespace sagara::db
