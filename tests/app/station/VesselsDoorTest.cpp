// The admin's pages over a real store, without a display.
#include "app/station/VesselsDoor.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <QApplication>
#include <QLabel>
#include <QListWidget>
#include <QTest>

#include "core/vessel/Particulars.h"
#include "db/DocumentRepository.h"
#include "db/PersonRepository.h"
#include "tests/app/station/NoWindow.h"
#include "ui/theme/Theme.h"
#include "ui/vessels/DatabasePage.h"
#include "ui/vessels/VesselsPage.h"

namespace sagara::station {
namespace {

namespace fs = std::filesystem;

class Doors : public ::testing::Test {
protected:
    void SetUp() override {
        m_folder = fs::temp_directory_path() / ("sagara-doors-" + std::to_string(::getpid()));
        fs::remove_all(m_folder);
        auto store = run::Store::open(m_folder / "data");
        ASSERT_TRUE(store) << store.error();
        m_store = std::move(store).value();
        m_frame = std::make_unique<NoWindow>(*m_store);
    }
    void TearDown() override {
        m_frame.reset();
        m_store.reset();
        fs::remove_all(m_folder);
    }
    db::DocumentEntry entry(const std::string& id) {
        return db::DocumentRepository(*m_store->database(), db::DocumentTable::Vessel).entry(id).value();
    }
    fs::path m_folder;
    std::unique_ptr<run::Store> m_store;
    std::unique_ptr<NoWindow> m_frame;
};

TEST_F(Doors, VesselsAreThoseOfTheDatabaseAndAUsedOneIsNotDeleted) {
    const std::unique_ptr<ui::Page> page(vesselsPage(*m_frame));
    auto* const vessels = dynamic_cast<ui::VesselsPage*>(page.get());
    ASSERT_NE(vessels, nullptr);
    page->show();
    EXPECT_GE(page->findChild<QListWidget*>(QStringLiteral("vessels"))->count(), 2);
    ASSERT_TRUE(vessels->choose("patrol51"));
    vessels->retireOrRestore();
    EXPECT_TRUE(page->findChild<QLabel*>(QStringLiteral("message"))
                    ->text()
                    .contains(QStringLiteral("Basic Navigation")));
    EXPECT_FALSE(entry("patrol51").retired);
    EXPECT_EQ(entry("patrol51").origin, db::Origin::Shipped);

    // Out and in again: the copy is the school's own, the shipped one as it was.
    ASSERT_FALSE(vessels->exportTo(m_folder / "patrol.json"));
    ASSERT_FALSE(vessels->importFrom(m_folder / "patrol.json"));
    EXPECT_EQ(vessels->chosen(), "patrol51-2");
    EXPECT_EQ(entry("patrol51-2").origin, db::Origin::User);
    EXPECT_EQ(entry("patrol51").origin, db::Origin::Shipped);
    vessels->retireOrRestore();
    EXPECT_TRUE(entry("patrol51-2").retired);
}

TEST_F(Doors, TheDatabaseIsBackedUpAndRestored) {
    ASSERT_TRUE(db::PersonRepository(*m_store->database()).add("Before", db::Role::Trainee, run::now()));
    const std::unique_ptr<ui::Page> page(databasePage(*m_frame));
    auto* const database = dynamic_cast<ui::DatabasePage*>(page.get());
    ASSERT_NE(database, nullptr);
    page->show();
    const auto state = [&] {
        return page->findChild<QLabel*>(QStringLiteral("databaseState"))->text().toStdString();
    };
    const auto finish = [&] { ASSERT_TRUE(QTest::qWaitFor([&] { return !database->busy(); }, 20000)); };
    database->check();
    finish();
    EXPECT_NE(state().find("whole"), std::string::npos) << state();
    const fs::path backup = m_folder / "backup.db";
    database->backupTo(backup);
    finish();
    ASSERT_TRUE(fs::exists(backup)) << state();

    ASSERT_TRUE(db::PersonRepository(*m_store->database()).add("After", db::Role::Trainee, run::now()));
    database->restoreFrom(backup, true);
    finish();
    EXPECT_NE(state().find("Restored"), std::string::npos) << state();
    ASSERT_NE(m_store->database(), nullptr);
    db::PersonRepository people(*m_store->database());
    EXPECT_TRUE(people.findByName("Before"));
    EXPECT_FALSE(people.findByName("After"));
    db::Database kept(m_store->keptDatabase());
    EXPECT_TRUE(db::PersonRepository(kept).findByName("After"));
    EXPECT_TRUE(m_store->find(core::DocumentKind::Vessel, "patrol51"));
}

TEST_F(Doors, ADamagedBackupIsRefusedAndTheDatabaseStays) {
    const fs::path bad = m_folder / "bad.db";
    std::FILE* const f = std::fopen(bad.c_str(), "wb");
    std::fputs("this is no database", f);
    std::fclose(f);
    EXPECT_FALSE(m_store->checkBackup(bad).empty());
    EXPECT_FALSE(m_store->checkBackup(m_folder / "nothing.db").empty());
    EXPECT_TRUE(m_store->restoreDatabase(bad));
    ASSERT_NE(m_store->database(), nullptr);
    EXPECT_TRUE(m_store->database()->integrity().empty());
    int files = 0;  // nothing half made is left
    for (const auto& entry : fs::directory_iterator(m_store->folder().root()))
        files += entry.path().filename().string().starts_with("sagara-");
    EXPECT_EQ(files, 0);
}

}  // namespace
}  // namespace sagara::station

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    QApplication application(argc, argv);
    sagara::ui::applyTheme(application, sagara::ui::PaletteName::Day);
    return RUN_ALL_TESTS();
}
