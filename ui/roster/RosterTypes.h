#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/Utc.h"

/// What the pages of the roster show and ask for. Plain values; ids are the school's, 0 means none.
namespace sagara::ui::roster {

enum class Role { Trainee, Trainer, Admin };

struct Person {
    std::int64_t id = 0;
    QString name;
    QString number;
    QString rank;
    QString note;
    Role role = Role::Trainee;
    std::int64_t classId = 0;
    QString className;  ///< what counts when a person is saved: a class of that name is made when new
    bool retired = false;
};

struct SchoolClass {
    std::int64_t id = 0;
    QString name;
    int people = 0;
};

struct Mission {
    QString key;
    QString name;
};

enum class State { Open, Done, Late, Withdrawn };

struct Member {
    QString name;
    State state = State::Open;
    std::optional<core::Utc> done;
};

struct Assignment {
    std::int64_t id = 0;
    QString mission;
    std::int64_t personId = 0;  ///< or
    std::int64_t classId = 0;
    QString forWhom;
    core::Utc due;
    core::Utc created;
    QString type;  ///< "assess", as the database has it
    int level = 3;
    QString assignedBy;
    State state = State::Open;
    std::vector<Member> members;
};

struct NewAssignment {
    Mission mission;
    std::int64_t personId = 0;
    std::int64_t classId = 0;
    core::Utc due;
    QString type;
    int level = 3;
    std::int64_t assignedBy = 0;
};

struct Score {
    double points = 0.0;  ///< 0 to 100
    bool passed = false;
};

struct Run {
    std::int64_t id = 0;
    core::Utc started;
    QString person;
    QString className;
    QString mission;
    QString type;
    int level = 3;
    QString status;  ///< "running", "finished", "aborted"
    double duration_s = 0.0;
    std::optional<Score> automatic;
    std::optional<Score> overruled;
    QString signedBy;
};

struct RunFilter {
    std::int64_t personId = 0;
    std::int64_t classId = 0;
    QString missionKey;
    QString type;
};

/// What somebody's runs come to.
struct Record {
    int grades = 0;
    int passedGrades = 0;
    int practice = 0;
};

/// The assessor's part of a result.
struct Entry {
    QString comment;
    bool overrule = false;
    double score = 0.0;
    bool passed = false;
    QString reason;
    friend bool operator==(const Entry&, const Entry&) = default;
};

struct Result {
    struct Task {
        QString title;
        bool done = false;
        double time_s = 0.0;
    };
    struct Loss {
        double time_s = 0.0;
        QString title;
        QString unit;
        double value = 0.0;
        double limit = 0.0;
        double points = 0.0;
        bool fails = false;
    };
    QString mission;
    QString person;  ///< empty: nobody named
    QString type;
    int level = 3;
    core::Utc started;
    double duration_s = 0.0;
    std::optional<Score> automatic;  ///< none: not graded
    QString whyNot;
    std::vector<Task> tasks;
    std::vector<Loss> losses;
    QString cannotAssess;  ///< why no assessment can be kept; empty: it can
    Entry entry;
    QString signedBy;
    std::optional<core::Utc> signedAt;
};

}  // namespace sagara::ui::roster
