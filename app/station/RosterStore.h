#pragma once

#include <map>

#include "app/station/Frame.h"
#include "db/AssignmentProgress.h"
#include "db/Database.h"
#include "db/RunHistory.h"
#include "ui/roster/RosterPort.h"

namespace sagara::station {

namespace roster = ui::roster;

/// Does something with the database and tells what went wrong as a text, be it the database or the entry.
template <typename Do>
roster::Trouble attempt(run::Store& store, Do&& act) {
    if (!store.database()) return QString::fromStdString(store.trouble());
    try {
        return act(*store.database());
    } catch (const db::DbError& e) {
        return QString::fromStdString(e.what());
    }
}

inline QString fromStd(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// Writes the report of a run of the database, with its assessment as it is kept now.
core::Result<roster::Job, QString> reportJobOf(run::Store& store, db::RunId run, const QString& file);
/// Opens the debriefing of a recording, when its file is there.
roster::Trouble debriefOf(Frame& frame, const std::string& recordingName);

/// The roster page's port over the database.
class RosterStore final : public roster::RosterPort {
public:
    explicit RosterStore(Frame& frame) : m_frame(frame) {}

    QString trouble() const override { return m_trouble; }
    core::Utc now() const override;
    std::vector<roster::Person> people() override;
    std::vector<roster::SchoolClass> classes() override;
    std::vector<roster::Mission> missions() override;
    core::Result<std::int64_t, QString> savePerson(const roster::Person& person) override;
    roster::Trouble retirePerson(std::int64_t id, bool retired) override;
    roster::Trouble movePeople(const std::vector<std::int64_t>& ids, const QString& className) override;
    roster::Trouble importPeople(const std::vector<roster::Person>& people) override;
    roster::Trouble addClass(const QString& name) override;
    roster::Trouble renameClass(std::int64_t id, const QString& name) override;
    roster::Trouble retireClass(std::int64_t id) override;
    std::vector<roster::Assignment> assignments() override;
    roster::Trouble assign(const roster::NewAssignment& assignment) override;
    roster::Trouble withdraw(std::int64_t id) override;
    std::vector<roster::Run> runs(const roster::RunFilter& filter, int most) override;
    int runCount(const roster::RunFilter& filter) override;
    roster::Record recordOf(std::int64_t person) override;
    roster::Trouble openDebrief(std::int64_t run) override;
    roster::Trouble openResult(std::int64_t run) override;
    core::Result<roster::Job, QString> reportJob(std::int64_t run, const QString& file) override;

private:
    /// Reads; what goes wrong is kept for `trouble`.
    template <typename Read>
    void read(Read&& act);

    Frame& m_frame;
    QString m_trouble;
};

roster::Person personOf(const db::PersonRecord& record, const std::string& className);

}  // namespace sagara::station
