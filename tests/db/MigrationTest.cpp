#include "db/sql/Migrate.h"

#include <gtest/gtest.h>

#include <array>

#include "Support.h"
#include "core/base/Hash.h"
#include "db/AssessmentRepository.h"
#include "db/AssignmentRepository.h"
#include "db/RunHistory.h"
#include "db/SettingRepository.h"
#include "db/schema/Schema.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace test;
using namespace Qt::StringLiterals;
namespace fs = std::filesystem;

const fs::path kSamples = SAGARA_DB_SAMPLES;

fs::path sampleOf(int version) { return kSamples / ("v" + std::to_string(version) + ".sql"); }

/// Everything in a schema, for comparison.
std::string schemaOf(Database& db) {
    Query row(db.connection(), u"SELECT sql FROM sqlite_schema WHERE sql IS NOT NULL ORDER BY type, name"_s);
    std::string all;
    while (row.next()) all += row.text(u"sql"_s) + "\n";
    return all;
}

class StoredSample : public ::testing::TestWithParam<int> {
protected:
    StoredSample() { executeScript(m_folder / "sagara.db", sampleOf(GetParam())); }
    TemporaryFolder m_folder;
};

TEST_P(StoredSample, IsRaisedToTheSchemaOfANewFile) {
    Database raised(m_folder / "sagara.db"), fresh(m_folder / "fresh.db");
    EXPECT_EQ(raised.info().schemaVersion, kSchemaVersion);
    EXPECT_EQ(schemaOf(raised), schemaOf(fresh));
    EXPECT_TRUE(raised.integrity().empty());
}

TEST_P(StoredSample, KeepsEveryRow) {
    Database db(m_folder / "sagara.db");
    DocumentRepository vessels(db, DocumentTable::Vessel);
    EXPECT_EQ(vessels.find("patrol51")->text, "{\"id\": \"patrol51\", \"name\": \"it's new\"}");
    EXPECT_TRUE(vessels.findByHash(core::hashOf("{\"id\": \"patrol51\", \"name\": \"old\"}")));
    EXPECT_TRUE(DocumentRepository(db, DocumentTable::Area).entry("galle")->retired);
    EXPECT_EQ(DocumentRepository(db, DocumentTable::Scenario).inUse().size(), 1u);
    EXPECT_EQ(SettingRepository(db).find("language"), "si");
    const PersonRecord person = PersonRepository(db).findByName("නිමල් O'Brien").value();
    const RunRecord run = RunRepository(db).findByRecording("recordings/a.sagarec").value();
    EXPECT_EQ(run.start.person, person.id);
    EXPECT_EQ(run.start.seed, 0xffffffffffffffff);
    EXPECT_EQ(run.stateHash, ended().stateHash);
    EXPECT_EQ(GradeRepository(db).find(run.id), good());
    EXPECT_EQ(RunRepository(db).findByRecording("recordings/b.sagarec")->status, RunStatus::Running);
}

TEST_P(StoredSample, StaysBesideTheRaisedOneAsItWas) {
    const fs::path file = m_folder / "sagara.db", copy = olderCopy(file, GetParam());
    { Database raised(file); }
    ASSERT_EQ(fs::exists(copy), GetParam() < kSchemaVersion);
    if (!fs::exists(copy)) return;
    EXPECT_EQ(copy.filename(), "sagara-version-" + std::to_string(GetParam()) + ".db");
    Connection kept(copy, Connection::Access::ReadOnly, kBusyTimeout);
    EXPECT_EQ(schemaVersion(kept), GetParam());
    Query people(kept, u"SELECT name FROM person"_s);
    EXPECT_TRUE(people.next());
    { Database again(file); }
    EXPECT_EQ(schemaVersion(kept), GetParam());
}

TEST_P(StoredSample, IsReadyForWhatIsNew) {
    Database db(m_folder / "sagara.db");
    const PersonRecord person = PersonRepository(db).findByName("නිමල් O'Brien").value();
    EXPECT_EQ(RunHistory(db).gradesOf(person.id).size(), 1u);
    const PersonId trainer = *PersonRepository(db).add("Silva", Role::Trainer, kNoon);
    const RunId run = RunRepository(db).findByRecording("recordings/a.sagarec")->id;
    AssessmentRepository assessments(db);
    if (GetParam() < 2) {
        EXPECT_EQ(person.number + person.rank + person.note, "");
        EXPECT_FALSE(person.schoolClass);
        EXPECT_TRUE(assessments.put(run, {"good", {}}, kNoon));
        EXPECT_TRUE(assessments.sign(run, trainer, kNoon));
        return;
    }
    EXPECT_EQ(person.number, "NA-17");
    EXPECT_EQ(ClassRepository(db).find(*person.schoolClass)->name, "Watch A");
    EXPECT_EQ(AssignmentRepository(db).openFor(person.id).size(), 1u);
    EXPECT_EQ(assessments.find(run)->signedOff->name, "A. Silva");
    EXPECT_EQ(assessments.put(run, {}, kNoon).error(), AssessError::SignedAlready);
}

INSTANTIATE_TEST_SUITE_P(OfEveryVersion, StoredSample, ::testing::Range(1, kSchemaVersion + 1));

void addSpeed(Connection& c) { execute(c, u"ALTER TABLE setting ADD COLUMN speed INTEGER"_s); }
void renameSetting(Connection& c) { execute(c, u"ALTER TABLE setting RENAME TO preference"_s); }
void makeNothing(Connection& c) { execute(c, u"CREATE TABLE setting (nothing INTEGER)"_s); }
void orphanRuns(Connection& c) { execute(c, u"UPDATE run SET person_id = 4711"_s); }

class Migrations : public ::testing::Test {
protected:
    std::filesystem::path makeFile() const {
        executeScript(m_folder / "sagara.db", sampleOf(1));
        return m_folder / "sagara.db";
    }
    TemporaryFolder m_folder;
    Connection m_connection{makeFile(), Connection::Access::ReadWrite, kBusyTimeout};
};

TEST_F(Migrations, OnlyTheMissingOnesRunAndInOrder) {
    const std::array<Migration, 3> list{toVersion1, addSpeed, renameSetting};
    migrate(m_connection, list);
    EXPECT_EQ(schemaVersion(m_connection), 3);
    Query row(m_connection, u"SELECT key, speed FROM preference"_s);
    EXPECT_TRUE(row.next());
}

TEST_F(Migrations, FailureUndoesAllOfThem) {
    const std::array<Migration, 3> list{toVersion1, addSpeed, makeNothing};
    EXPECT_THROW(migrate(m_connection, list), DbError);
    EXPECT_EQ(schemaVersion(m_connection), 1);
    EXPECT_THROW(execute(m_connection, u"SELECT speed FROM setting"_s), DbError);
}

TEST_F(Migrations, DanglingReferenceUndoesThem) {
    const std::array<Migration, 2> list{toVersion1, orphanRuns};
    const DbError error = errorOf([&] { migrate(m_connection, list); });
    EXPECT_NE(std::string(error.what()).find("table run refers to a missing row of person"),
              std::string::npos);
    EXPECT_EQ(schemaVersion(m_connection), 1);
}

TEST_F(Migrations, SecondProgramThatComesLateFindsThemDone) {
    const std::array<Migration, 2> list{toVersion1, addSpeed};
    Connection other(m_folder / "sagara.db", Connection::Access::ReadWrite, kBusyTimeout);
    EXPECT_EQ(schemaVersion(other), 1);
    migrate(m_connection, list);
    migrate(other, list);
    EXPECT_EQ(schemaVersion(other), 2);
}

// Writes the sample of the present version: see tests/db/README.md.
TEST(Sample, DISABLED_IsWrittenToTheFileInSagaraSample) {
    const char* file = std::getenv("SAGARA_SAMPLE");
    ASSERT_TRUE(file) << "set SAGARA_SAMPLE to the database file to make";
    Database db(file);
    DocumentRepository(db, DocumentTable::Vessel)
        .put(patrol("{\"id\": \"patrol51\", \"name\": \"old\"}"), kMorning);
    DocumentRepository(db, DocumentTable::Vessel)
        .put(patrol("{\"id\": \"patrol51\", \"name\": \"it's new\"}"), kNoon);
    DocumentRepository areas(db, DocumentTable::Area);
    areas.put({.key = "galle", .name = "Galle", .text = "{}", .origin = Origin::User}, kMorning);
    areas.retire("galle");
    DocumentRepository(db, DocumentTable::Scenario)
        .put({.key = "basic-navigation", .name = "Basic Navigation", .text = "{}"}, kMorning);
    NewRun run = lesson();
    const ClassId watch = *ClassRepository(db).add("Watch A", kMorning);
    run.person = *PersonRepository(db).add(
        {"නිමල් O'Brien", Role::Trainee, "NA-17", "Sub-Lieutenant", "nimal@example.org", watch}, kMorning);
    run.seed = 0xffffffffffffffff;
    const RunId filed = fileRun(db, {run, ended(), good()});
    const PersonId trainer = *PersonRepository(db).add("A. Silva", Role::Trainer, kMorning);
    ASSERT_TRUE(AssessmentRepository(db).put(filed, {"too fast", Overrule{60.0, true, "weather"}}, kNoon));
    ASSERT_TRUE(AssessmentRepository(db).sign(filed, trainer, kNoon));
    NewAssignment mission;
    mission.scenarioKey = "basic-navigation";
    mission.scenarioName = "Basic Navigation";
    mission.forWhom = watch;
    mission.due = {kNoon.unix_s + 86'400};
    mission.assignedBy = trainer;
    ASSERT_TRUE(AssignmentRepository(db).add(mission, kNoon));
    RunRepository(db).start(lesson("recordings/b.sagarec"));
    SettingRepository(db).put("language", "si");
}

}  // namespace
}  // namespace sagara::db
