PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE vessel (
    id INTEGER PRIMARY KEY,
    key TEXT NOT NULL UNIQUE CHECK (key <> ''),
    name TEXT NOT NULL,
    document TEXT NOT NULL,
    content_hash TEXT NOT NULL CHECK (length(content_hash) = 16),
    origin TEXT NOT NULL CHECK (origin IN ('shipped', 'user')),
    retired INTEGER NOT NULL DEFAULT 0 CHECK (retired IN (0, 1)),
    changed_utc TEXT NOT NULL
) STRICT;
INSERT INTO vessel VALUES(1,'patrol51','Patrol vessel','{"id": "patrol51", "name": "it''s new"}','1d730a65f1db1aee','shipped',0,'2027-01-15T12:00:00Z');
CREATE TABLE area (
    id INTEGER PRIMARY KEY,
    key TEXT NOT NULL UNIQUE CHECK (key <> ''),
    name TEXT NOT NULL,
    document TEXT NOT NULL,
    content_hash TEXT NOT NULL CHECK (length(content_hash) = 16),
    origin TEXT NOT NULL CHECK (origin IN ('shipped', 'user')),
    retired INTEGER NOT NULL DEFAULT 0 CHECK (retired IN (0, 1)),
    changed_utc TEXT NOT NULL
) STRICT;
INSERT INTO area VALUES(1,'galle','Galle','{}','08f44b07b5901a25','user',1,'2027-01-15T08:00:00Z');
CREATE TABLE scenario (
    id INTEGER PRIMARY KEY,
    key TEXT NOT NULL UNIQUE CHECK (key <> ''),
    name TEXT NOT NULL,
    document TEXT NOT NULL,
    content_hash TEXT NOT NULL CHECK (length(content_hash) = 16),
    origin TEXT NOT NULL CHECK (origin IN ('shipped', 'user')),
    retired INTEGER NOT NULL DEFAULT 0 CHECK (retired IN (0, 1)),
    changed_utc TEXT NOT NULL
) STRICT;
INSERT INTO scenario VALUES(1,'basic-navigation','Basic Navigation','{}','08f44b07b5901a25','shipped',0,'2027-01-15T08:00:00Z');
CREATE TABLE document_history (
    id INTEGER PRIMARY KEY,
    document_table TEXT NOT NULL CHECK (document_table IN ('vessel', 'area', 'scenario')),
    key TEXT NOT NULL,
    content_hash TEXT NOT NULL CHECK (length(content_hash) = 16),
    document TEXT NOT NULL,
    replaced_utc TEXT NOT NULL,
    UNIQUE (document_table, content_hash, key)
) STRICT;
INSERT INTO document_history VALUES(1,'vessel','patrol51','af58228c4010dfea','{"id": "patrol51", "name": "old"}','2027-01-15T12:00:00Z');
CREATE TABLE person (
    id INTEGER PRIMARY KEY,
    name TEXT NOT NULL CHECK (length(name) BETWEEN 1 AND 80),
    role TEXT NOT NULL CHECK (role IN ('trainee', 'trainer', 'admin')),
    created_utc TEXT NOT NULL,
    retired INTEGER NOT NULL DEFAULT 0 CHECK (retired IN (0, 1))
, number TEXT NOT NULL DEFAULT '' CHECK (length(number) <= 40), rank TEXT NOT NULL DEFAULT '' CHECK (length(rank) <= 40), note TEXT NOT NULL DEFAULT '' CHECK (length(note) <= 400), class_id INTEGER REFERENCES class (id)) STRICT;
INSERT INTO person VALUES(1,'නිමල් O''Brien','trainee','2027-01-15T08:00:00Z',0,'NA-17','Sub-Lieutenant','nimal@example.org',1);
INSERT INTO person VALUES(2,'A. Silva','trainer','2027-01-15T08:00:00Z',0,'','','',NULL);
CREATE TABLE run (
    id INTEGER PRIMARY KEY,
    person_id INTEGER REFERENCES person (id),
    scenario_key TEXT NOT NULL,
    scenario_name TEXT NOT NULL,
    type TEXT NOT NULL CHECK (type IN ('familiarise', 'train', 'assess', 'self-study', 'demo')),
    level INTEGER NOT NULL CHECK (level BETWEEN 1 AND 5),
    seed INTEGER NOT NULL,
    build_id TEXT NOT NULL,
    started_utc TEXT NOT NULL,
    finished_utc TEXT,
    status TEXT NOT NULL CHECK (status IN ('running', 'finished', 'aborted')),
    sim_time_us INTEGER NOT NULL DEFAULT 0 CHECK (sim_time_us >= 0),
    state_hash TEXT CHECK (length(state_hash) = 16),
    recording_file TEXT NOT NULL UNIQUE CHECK (recording_file <> ''),
    CHECK ((status = 'running') = (finished_utc IS NULL))
) STRICT;
INSERT INTO run VALUES(1,1,'basic-navigation','Basic Navigation','assess',3,-1,'0.1.0','2027-01-15T08:00:00Z','2027-01-15T12:00:00Z','finished',1234560000,'0123456789abcdef','recordings/a.sagarec');
INSERT INTO run VALUES(2,NULL,'basic-navigation','Basic Navigation','assess',3,7,'0.1.0','2027-01-15T08:00:00Z',NULL,'running',0,NULL,'recordings/b.sagarec');
CREATE TABLE grade (
    id INTEGER PRIMARY KEY,
    run_id INTEGER NOT NULL UNIQUE REFERENCES run (id),
    score REAL NOT NULL CHECK (score BETWEEN 0 AND 100),
    passed INTEGER NOT NULL CHECK (passed IN (0, 1)),
    tasks TEXT NOT NULL CHECK (json_valid(tasks)),
    deductions TEXT NOT NULL CHECK (json_valid(deductions)),
    advisory INTEGER NOT NULL DEFAULT 1 CHECK (advisory IN (0, 1)),
    made_utc TEXT NOT NULL
) STRICT;
INSERT INTO grade VALUES(1,1,87.5,1,'[{"id": "lines", "done": true}]','[{"what": "speed", "points": 12.5}]',1,'2027-01-15T12:00:00Z');
CREATE TABLE setting (
    key TEXT NOT NULL PRIMARY KEY CHECK (key <> ''),
    value TEXT NOT NULL
) STRICT;
INSERT INTO setting VALUES('language','si');
CREATE TABLE class (
    id INTEGER PRIMARY KEY,
    name TEXT NOT NULL CHECK (length(name) BETWEEN 1 AND 80),
    created_utc TEXT NOT NULL,
    retired INTEGER NOT NULL DEFAULT 0 CHECK (retired IN (0, 1))
) STRICT;
INSERT INTO class VALUES(1,'Watch A','2027-01-15T08:00:00Z',0);
CREATE TABLE assignment (
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
) STRICT;
INSERT INTO assignment VALUES(1,'basic-navigation','Basic Navigation',NULL,1,'2027-01-16T12:00:00Z','train',3,2,'2027-01-15T12:00:00Z',NULL);
CREATE TABLE assessment (
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
) STRICT;
INSERT INTO assessment VALUES(1,1,'too fast',60.0,1,'weather','2027-01-15T12:00:00Z',2,'A. Silva','2027-01-15T12:00:00Z');
CREATE TABLE seakeeping (
    id INTEGER PRIMARY KEY,
    input_hash INTEGER NOT NULL UNIQUE,
    tables BLOB NOT NULL
) STRICT;
CREATE INDEX vessel_content_hash ON vessel (content_hash);
CREATE INDEX area_content_hash ON area (content_hash);
CREATE INDEX scenario_content_hash ON scenario (content_hash);
CREATE UNIQUE INDEX person_name_in_use ON person (name) WHERE retired = 0;
CREATE INDEX run_person ON run (person_id);
CREATE INDEX run_started ON run (started_utc, id);
CREATE UNIQUE INDEX class_name_in_use ON class (name) WHERE retired = 0;
CREATE UNIQUE INDEX person_number_in_use ON person (number) WHERE retired = 0 AND number <> '';
CREATE INDEX person_class ON person (class_id);
CREATE INDEX assignment_person ON assignment (person_id);
CREATE INDEX assignment_class ON assignment (class_id);
CREATE TRIGGER assessment_signed_stays BEFORE UPDATE ON assessment WHEN OLD.signed_utc IS NOT NULL BEGIN SELECT RAISE(ABORT, 'the assessment was signed off'); END;
CREATE TRIGGER assessment_signed_is_kept BEFORE DELETE ON assessment WHEN OLD.signed_utc IS NOT NULL BEGIN SELECT RAISE(ABORT, 'the assessment was signed off'); END;
CREATE TRIGGER grade_signed_stays BEFORE UPDATE ON grade WHEN EXISTS (SELECT 1 FROM assessment WHERE run_id = OLD.run_id AND signed_utc IS NOT NULL) BEGIN SELECT RAISE(ABORT, 'the assessment of this grade was signed off'); END;
CREATE TRIGGER grade_signed_is_kept BEFORE DELETE ON grade WHEN EXISTS (SELECT 1 FROM assessment WHERE run_id = OLD.run_id AND signed_utc IS NOT NULL) BEGIN SELECT RAISE(ABORT, 'the assessment of this grade was signed off'); END;
CREATE VIEW run_history AS SELECT
    run.id AS run_id, run.person_id, person.name AS person_name, person.class_id, class.name AS class_name,
    run.scenario_key, run.scenario_name, run.type, run.level, run.started_utc, run.status, run.sim_time_us,
    run.recording_file, grade.score, grade.passed, assessment.overruled_score, assessment.overruled_passed,
    assessment.signed_name, assessment.signed_utc
FROM run LEFT JOIN person ON person.id = run.person_id LEFT JOIN class ON class.id = person.class_id
    LEFT JOIN grade ON grade.run_id = run.id LEFT JOIN assessment ON assessment.run_id = run.id;
COMMIT;
PRAGMA application_id = 1396787009;
PRAGMA user_version = 3;
