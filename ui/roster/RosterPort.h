#pragma once

#include <optional>
#include <vector>

#include "core/base/Result.h"
#include "ui/roster/Job.h"
#include "ui/roster/RosterTypes.h"

namespace sagara::ui::roster {

/// Nothing, or what went wrong, for the person who asked.
using Trouble = std::optional<QString>;

/// The school's records as the roster page sees them. Whoever opens the page supplies it; every call takes a
/// few milliseconds.
class RosterPort {
public:
    virtual ~RosterPort() = default;

    /// Why nothing can be read or kept just now; empty when all is well. Lists are empty then.
    virtual QString trouble() const = 0;
    virtual core::Utc now() const = 0;

    virtual std::vector<Person> people() = 0;  ///< retired ones too, by name
    virtual std::vector<SchoolClass> classes() = 0;
    virtual std::vector<Mission> missions() = 0;
    /// With id 0 somebody new. Gives the id.
    virtual core::Result<std::int64_t, QString> savePerson(const Person& person) = 0;
    virtual Trouble retirePerson(std::int64_t id, bool retired) = 0;
    /// An empty name: no class.
    virtual Trouble movePeople(const std::vector<std::int64_t>& ids, const QString& className) = 0;
    /// All of them or none.
    virtual Trouble importPeople(const std::vector<Person>& people) = 0;
    virtual Trouble addClass(const QString& name) = 0;
    virtual Trouble renameClass(std::int64_t id, const QString& name) = 0;
    virtual Trouble retireClass(std::int64_t id) = 0;

    virtual std::vector<Assignment> assignments() = 0;  ///< the earliest due first
    virtual Trouble assign(const NewAssignment& assignment) = 0;
    virtual Trouble withdraw(std::int64_t id) = 0;

    virtual std::vector<Run> runs(const RunFilter& filter, int most) = 0;  ///< newest first
    virtual int runCount(const RunFilter& filter) = 0;
    virtual Record recordOf(std::int64_t person) = 0;
    virtual Trouble openDebrief(std::int64_t run) = 0;
    virtual Trouble openResult(std::int64_t run) = 0;
    virtual core::Result<Job, QString> reportJob(std::int64_t run, const QString& file) = 0;
};

/// One run's result and its assessment.
class ResultPort {
public:
    virtual ~ResultPort() = default;

    virtual Result result() = 0;
    virtual std::vector<Person> assessors() = 0;  ///< who may sign it off
    virtual Trouble save(const Entry& entry) = 0;
    virtual Trouble signOff(const Entry& entry, std::int64_t by) = 0;
    virtual Trouble openDebrief() = 0;
    virtual core::Result<Job, QString> reportJob(const QString& file) = 0;
};

}  // namespace sagara::ui::roster
