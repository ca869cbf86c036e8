#include "db/schema/Schema.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;

// Instants are "2027-01-15T03:30:00Z" and hashes 16 hexadecimal digits: readable with any SQLite tool.

const auto kVessel =
    uR"(CREATE TABLE vessel (
    id INTEGER PRIMARY KEY,
    key TEXT NOT NULL UNIQUE CHECK (key <> ''),
    name TEXT NOT NULL,
    document TEXT NOT NULL,
    content_hash TEXT NOT NULL CHECK (length(content_hash) = 16),
    origin TEXT NOT NULL CHECK (origin IN ('shipped', 'user')),
    retired INTEGER NOT NULL DEFAULT 0 CHECK (retired IN (0, 1)),
    changed_utc TEXT NOT NULL
) STRICT)"_s;
const auto kVesselHash = u"CREATE INDEX vessel_content_hash ON vessel (content_hash)"_s;

const auto kArea =
    uR"(CREATE TABLE area (
    id INTEGER PRIMARY KEY,
    key TEXT NOT NULL UNIQUE CHECK (key <> ''),
    name TEXT NOT NULL,
    document TEXT NOT NULL,
    content_hash TEXT NOT NULL CHECK (length(content_hash) = 16),
    origin TEXT NOT NULL CHECK (origin IN ('shipped', 'user')),
    retired INTEGER NOT NULL DEFAULT 0 CHECK (retired IN (0, 1)),
    changed_utc TEXT NOT NULL
) STRICT)"_s;
const auto kAreaHash = u"CREATE INDEX area_content_hash ON area (content_hash)"_s;

const auto kScenario =
    uR"(CREATE TABLE scenario (
    id INTEGER PRIMARY KEY,
    key TEXT NOT NULL UNIQUE CHECK (key <> ''),
    name TEXT NOT NULL,
    document TEXT NOT NULL,
    content_hash TEXT NOT NULL CHECK (length(content_hash) = 16),
    origin TEXT NOT NULL CHECK (origin IN ('shipped', 'user')),
    retired INTEGER NOT NULL DEFAULT 0 CHECK (retired IN (0, 1)),
    changed_utc TEXT NOT NULL
) STRICT)"_s;
const auto kScenarioHash = u"CREATE INDEX scenario_content_hash ON scenario (content_hash)"_s;

const auto kHistory =
    uR"(CREATE TABLE document_history (
    id INTEGER PRIMARY KEY,
    document_table TEXT NOT NULL CHECK (document_table IN ('vessel', 'area', 'scenario')),
    key TEXT NOT NULL,
    content_hash TEXT NOT NULL CHECK (length(content_hash) = 16),
    document TEXT NOT NULL,
    replaced_utc TEXT NOT NULL,
    UNIQUE (document_table, content_hash, key)
) STRICT)"_s;

const auto kPerson =
    uR"(CREATE TABLE person (
    id INTEGER PRIMARY KEY,
    name TEXT NOT NULL CHECK (length(name) BETWEEN 1 AND 80),
    role TEXT NOT NULL CHECK (role IN ('trainee', 'trainer', 'admin')),
    created_utc TEXT NOT NULL,
    retired INTEGER NOT NULL DEFAULT 0 CHECK (retired IN (0, 1))
) STRICT)"_s;
const auto kPersonName = u"CREATE UNIQUE INDEX person_name_in_use ON person (name) WHERE retired = 0"_s;

// seed holds 64 bits without a sign, as SQLite's signed integer of the same bits.
const auto kRun =
    uR"(CREATE TABLE run (
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
) STRICT)"_s;
const auto kRunPerson = u"CREATE INDEX run_person ON run (person_id)"_s;
const auto kRunStarted = u"CREATE INDEX run_started ON run (started_utc, id)"_s;

const auto kGrade =
    uR"(CREATE TABLE grade (
    id INTEGER PRIMARY KEY,
    run_id INTEGER NOT NULL UNIQUE REFERENCES run (id),
    score REAL NOT NULL CHECK (score BETWEEN 0 AND 100),
    passed INTEGER NOT NULL CHECK (passed IN (0, 1)),
    tasks TEXT NOT NULL CHECK (json_valid(tasks)),
    deductions TEXT NOT NULL CHECK (json_valid(deductions)),
    advisory INTEGER NOT NULL DEFAULT 1 CHECK (advisory IN (0, 1)),
    made_utc TEXT NOT NULL
) STRICT)"_s;

const auto kSetting =
    uR"(CREATE TABLE setting (
    key TEXT NOT NULL PRIMARY KEY CHECK (key <> ''),
    value TEXT NOT NULL
) STRICT)"_s;

}  // namespace

void toVersion1(Connection& connection) {
    for (const QString& sql : {kVessel, kVesselHash, kArea, kAreaHash, kScenario, kScenarioHash, kHistory,
                               kPerson, kPersonName, kRun, kRunPerson, kRunStarted, kGrade, kSetting}) {
        execute(connection, sql);
    }
}

}  // namespace sagara::db
