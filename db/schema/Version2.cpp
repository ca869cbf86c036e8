#include "db/schema/Schema.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;

const auto kClass =
    uR"(CREATE TABLE class (
    id INTEGER PRIMARY KEY,
    name TEXT NOT NULL CHECK (length(name) BETWEEN 1 AND 80),
    created_utc TEXT NOT NULL,
    retired INTEGER NOT NULL DEFAULT 0 CHECK (retired IN (0, 1))
) STRICT)"_s;
const auto kClassName = u"CREATE UNIQUE INDEX class_name_in_use ON class (name) WHERE retired = 0"_s;

const auto kNumber =
    u"ALTER TABLE person ADD COLUMN number TEXT NOT NULL DEFAULT '' CHECK (length(number) <= 40)"_s;
const auto kRank =
    u"ALTER TABLE person ADD COLUMN rank TEXT NOT NULL DEFAULT '' CHECK (length(rank) <= 40)"_s;
const auto kNote =
    u"ALTER TABLE person ADD COLUMN note TEXT NOT NULL DEFAULT '' CHECK (length(note) <= 400)"_s;
const auto kPersonClass = u"ALTER TABLE person ADD COLUMN class_id INTEGER REFERENCES class (id)"_s;
const auto kPersonNumber =
    u"CREATE UNIQUE INDEX person_number_in_use ON person (number) WHERE retired = 0 AND number <> ''"_s;
const auto kPersonOfClass = u"CREATE INDEX person_class ON person (class_id)"_s;

const auto kAssignment =
    uR"(CREATE TABLE assignment (
    id INTEGER PRIMARY KEY,
    scenario_key TEXT NOT NULL CHECK (scenario_key <> ''),
    scenario_name TEXT NOT NULL,
    person_id INTEGER REFERENCES person (id),
    class_id INTEGER REFERENCES class (id),
    due_utc TEXT NOT NULL,
    type TEXT NOT NULL CHECK (type IN ('familiarise', 'train', 'assess', 'self-study')),
    level INTEGER NOT NULL CHECK (level BETWEEN 1 AND 5),
    assigned_by INTEGER REFERENCES person (id),
    created_utc TEXT NOT NULL,
    withdrawn_utc TEXT,
    CHECK ((person_id IS NULL) <> (class_id IS NULL))
) STRICT)"_s;
const auto kAssignmentPerson = u"CREATE INDEX assignment_person ON assignment (person_id)"_s;
const auto kAssignmentClass = u"CREATE INDEX assignment_class ON assignment (class_id)"_s;

const auto kAssessment =
    uR"(CREATE TABLE assessment (
    id INTEGER PRIMARY KEY,
    run_id INTEGER NOT NULL UNIQUE REFERENCES run (id),
    comment TEXT NOT NULL DEFAULT '',
    overruled_score REAL CHECK (overruled_score BETWEEN 0 AND 100),
    overruled_passed INTEGER CHECK (overruled_passed IN (0, 1)),
    reason TEXT NOT NULL DEFAULT '',
    changed_utc TEXT NOT NULL,
    signed_by INTEGER REFERENCES person (id),
    signed_name TEXT,
    signed_utc TEXT,
    CHECK ((overruled_score IS NULL) = (overruled_passed IS NULL)),
    CHECK (overruled_score IS NULL OR reason <> ''),
    CHECK ((signed_by IS NULL) = (signed_utc IS NULL)),
    CHECK ((signed_name IS NULL) = (signed_utc IS NULL))
) STRICT)"_s;

// What was signed off stays as it was, whoever asks. Each on one line: the samples of the tests are read by
// lines that end in a semicolon.
const auto kSignedStays =
    u"CREATE TRIGGER assessment_signed_stays BEFORE UPDATE ON assessment WHEN OLD.signed_utc IS NOT NULL "
    "BEGIN SELECT RAISE(ABORT, 'the assessment was signed off'); END"_s;
const auto kSignedIsKept =
    u"CREATE TRIGGER assessment_signed_is_kept BEFORE DELETE ON assessment WHEN OLD.signed_utc IS NOT NULL "
    "BEGIN SELECT RAISE(ABORT, 'the assessment was signed off'); END"_s;
const auto kSignedGradeStays =
    u"CREATE TRIGGER grade_signed_stays BEFORE UPDATE ON grade WHEN EXISTS (SELECT 1 FROM assessment "
    "WHERE run_id = OLD.run_id AND signed_utc IS NOT NULL) "
    "BEGIN SELECT RAISE(ABORT, 'the assessment of this grade was signed off'); END"_s;
const auto kSignedGradeIsKept =
    u"CREATE TRIGGER grade_signed_is_kept BEFORE DELETE ON grade WHEN EXISTS (SELECT 1 FROM assessment "
    "WHERE run_id = OLD.run_id AND signed_utc IS NOT NULL) "
    "BEGIN SELECT RAISE(ABORT, 'the assessment of this grade was signed off'); END"_s;

const auto kHistory =
    uR"(CREATE VIEW run_history AS SELECT
    run.id AS run_id, run.person_id, person.name AS person_name, person.class_id, class.name AS class_name,
    run.scenario_key, run.scenario_name, run.type, run.level, run.started_utc, run.status, run.sim_time_us,
    run.recording_file, grade.score, grade.passed, assessment.overruled_score, assessment.overruled_passed,
    assessment.signed_name, assessment.signed_utc
FROM run LEFT JOIN person ON person.id = run.person_id LEFT JOIN class ON class.id = person.class_id
    LEFT JOIN grade ON grade.run_id = run.id LEFT JOIN assessment ON assessment.run_id = run.id)"_s;

}  // namespace

void toVersion2(Connection& connection) {
    for (const QString& sql :
         {kClass, kClassName, kNumber, kRank, kNote, kPersonClass, kPersonNumber, kPersonOfClass, kAssignment,
          kAssignmentPerson, kAssignmentClass, kAssessment, kSignedStays, kSignedIsKept, kSignedGradeStays,
          kSignedGradeIsKept, kHistory}) {
        execute(connection, sql);
    }
}

}  // namespace sagara::db
