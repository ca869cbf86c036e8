#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/exercise/Documents.h"
#include "core/exercise/World.h"
#include "ui/widgets/PreparedChart.h"

/// What the practise pages know of the installation, and ask of it. Whoever opens the door supplies it.
namespace sagara::ui {

struct PractiseEntry {
    std::string id;
    std::string name;
};

/// A mission somebody is to sail.
struct PractiseAssignment {
    std::string scenario;
    QString name;
    QString due;         ///< date as people write it
    bool late = false;   ///< the date is behind
    bool alone = false;  ///< given as self-study: a run from here fulfils it
    int level = 3;
};

/// A run that person has sailed.
struct PastRun {
    std::string scenario;
    QString name;
    QString when;
    QString type;
    int level = 3;
    bool graded = false;
    double score = 0.0;
    bool passed = false;
    std::string recording;  ///< path; empty when it is not there any more
};

/// What is to be sailed.
struct PractiseChoice {
    std::string person;  ///< empty: nobody named
    int level = 3;
    bool prediction = true;
    bool hints = true;
    std::shared_ptr<const PreparedChart> chart = nullptr;  ///< of the exercise's area
};

struct PractisePorts {
    std::vector<std::string> people;
    std::vector<PractiseEntry> lessons;
    std::vector<PractiseEntry> vessels;
    std::vector<PractiseEntry> areas;
    /// Why that cannot be a name; empty when it can.
    std::function<QString(const std::string& name)> nameProblem;
    std::function<std::optional<std::string>(core::DocumentKind, const std::string& id)> find;
    /// The documents a scenario's text names; the error is for a person.
    std::function<core::Result<core::ExerciseDocuments, std::string>(core::NamedText scenario)> documents;
    std::function<std::vector<PractiseAssignment>(const std::string& person)> assignments;
    std::function<std::vector<PastRun>(const std::string& person)> history;  ///< newest first
    /// Opens the run. The error is for the person who chose.
    std::function<std::optional<std::string>(std::shared_ptr<const core::World>, const PractiseChoice&)> sail;
    /// The debriefing of a recording at that second. The error is for a person.
    std::function<std::optional<std::string>(const std::string& recording, double time_s)> replay;
};

}  // namespace sagara::ui
