#include "ui/vessels/DatabasePage.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <cstdlib>

#include "ui/theme/Theme.h"

namespace sagara::ui {
namespace {

class FakeCare final : public DatabaseCare {
public:
    std::vector<std::string> faults;
    std::vector<std::string> backupFaults;
    bool running = false;
    std::filesystem::path restored;

    Facts facts() const override {
        return {"/home/school/.local/share/sagara/sagara.db",
                4 << 20,
                1,
                {{"area", 1}, {"grade", 212}, {"person", 38}, {"run", 431}, {"scenario", 2}, {"vessel", 3}},
                ""};
    }
    bool runIsOn() const override { return running; }
    std::vector<std::string> checkIntegrity() const override { return faults; }
    std::vector<std::string> backupTo(const std::filesystem::path&) const override { return {}; }
    std::vector<std::string> checkBackup(const std::filesystem::path&) const override { return backupFaults; }
    std::optional<std::string> restore(const std::filesystem::path& backup) override {
        restored = backup;
        return std::nullopt;
    }
    std::filesystem::path keptCopy() const override {
        return "/home/school/.local/share/sagara/sagara-before-restore.db";
    }
};

class DatabaseWindow : public ::testing::Test {
protected:
    FakeCare care;
    DatabasePage page{care};

    QString state() { return page.findChild<QLabel*>(QStringLiteral("databaseState"))->text(); }
    void finish() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return !page.busy(); }, 10000));
    }
};

TEST_F(DatabaseWindow, ShowsWhatItIsAndChecksIt) {
    page.resize(1280, 720);
    page.setColours(PaletteName::Day);
    page.show();
    EXPECT_EQ(page.findChild<QTableWidget*>(QStringLiteral("rows"))->rowCount(), 6);
    QTest::mouseClick(page.findChild<QPushButton*>(QStringLiteral("checkIntegrity")), Qt::LeftButton);
    finish();
    EXPECT_TRUE(state().contains(QStringLiteral("whole"))) << state().toStdString();
    care.faults = {"vessel patrol51: the document is not the one stored"};
    page.check();
    finish();
    EXPECT_TRUE(state().contains(QStringLiteral("patrol51")));
    if (const char* folder = std::getenv("SAGARA_UI_PICTURES")) {
        for (const auto& [palette, word] :
             {std::pair{PaletteName::Day, "day"}, {PaletteName::Night, "night"}}) {
            applyTheme(*qobject_cast<QApplication*>(QApplication::instance()), palette);
            page.setColours(palette);
            QTest::qWait(100);
            page.grab().save(
                QStringLiteral("%1/database-%2.png").arg(QString::fromUtf8(folder), QLatin1String(word)));
        }
        applyTheme(*qobject_cast<QApplication*>(QApplication::instance()), PaletteName::Day);
    }
}

TEST_F(DatabaseWindow, BacksUpAndSaysWhere) {
    page.backupTo("/tmp/copy.db");
    EXPECT_TRUE(page.busy());
    EXPECT_FALSE(page.mayLeave());
    finish();
    EXPECT_TRUE(state().contains(QStringLiteral("/tmp/copy.db")));
}

TEST_F(DatabaseWindow, RestoresOnlyAWholeBackupAndNotDuringARun) {
    care.running = true;
    page.restoreFrom("/tmp/backup.db", true);
    EXPECT_FALSE(page.busy());
    EXPECT_TRUE(state().contains(QStringLiteral("run is on")));
    care.running = false;
    care.backupFaults = {"/tmp/backup.db is damaged"};
    page.restoreFrom("/tmp/backup.db", true);
    finish();
    EXPECT_TRUE(care.restored.empty());
    EXPECT_TRUE(state().contains(QStringLiteral("damaged")));
    care.backupFaults.clear();
    page.restoreFrom("/tmp/backup.db", true);
    finish();
    EXPECT_EQ(care.restored, "/tmp/backup.db");
}

}  // namespace
}  // namespace sagara::ui
