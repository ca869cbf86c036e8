#pragma once

#include <filesystem>
#include <optional>

#include "app/run/RunSummary.h"
#include "app/station/RosterStore.h"

namespace sagara::station {

/// The result page's port: a run of the database, or one that has just ended and may not be filed yet.
class ResultStore final : public roster::ResultPort {
public:
    ResultStore(Frame& frame, db::RunId run) : m_frame(frame), m_run(run) {}
    ResultStore(Frame& frame, std::filesystem::path recording, run::RunSummary summary);

    roster::Result result() override;
    std::vector<roster::Person> assessors() override;
    roster::Trouble save(const roster::Entry& entry) override;
    roster::Trouble signOff(const roster::Entry& entry, std::int64_t by) override;
    roster::Trouble openDebrief() override;
    core::Result<roster::Job, QString> reportJob(const QString& file) override;

private:
    void readFiled(db::Database& database, roster::Result& result) const;

    Frame& m_frame;
    std::optional<db::RunId> m_run;  ///< none: it could not be filed
    std::filesystem::path m_recording;
    std::optional<run::RunSummary> m_summary;
};

}  // namespace sagara::station
