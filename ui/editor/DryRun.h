#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include "core/base/Problems.h"
#include "core/exercise/Documents.h"
#include "ui/widgets/ChartScene.h"

namespace sagara::ui::editor {

/// What came of it.
struct DryRunResult {
    std::vector<core::config::Problem> problems;  ///< it could not be sailed
    bool cancelled = false;
    bool passed = false;
    double score = 0.0;
    double passScore = 0.0;
    double time_s = 0.0;
    QString failedBy;  ///< title of the criterion that failed the run; empty: none
    struct Task {
        QString id;
        QString title;
        bool done = false;
        double time_s = 0.0;
    };
    std::vector<Task> tasks;
    struct Loss {
        QString id;  ///< of the criterion
        QString title;
        QString found;  ///< "speed over ground 6.4 kn, limit 6 kn"
        double time_s = 0.0;
        double points = 0.0;
        core::NorthEast place;
    };
    std::vector<Loss> losses;
    ChartTrack track;
};

/// CONTROLLER: the scripted pilot sails a scenario as fast as it goes, in a thread of its own. Records nothing.
class DryRun final : public QObject {
    Q_OBJECT
public:
    struct Progress {
        double time_s = 0.0;
        double longest_s = 0.0;
        QString task;  ///< the one to be done now
        double score = 100.0;
        double timesRealTime = 0.0;
    };
    using QObject::QObject;
    ~DryRun() override;

    void start(std::string scenario, std::shared_ptr<const core::DocumentSource> documents, int level);
    void cancel() { m_cancel = true; }
    bool running() const { return m_running; }
    Progress progress() const;
    const DryRunResult& result() const { return m_result; }

Q_SIGNALS:
    void finished();

private:
    DryRunResult sail(const std::string& scenario, const core::DocumentSource& documents, int level);

    std::thread m_thread;
    std::atomic<bool> m_cancel = false;
    bool m_running = false;
    mutable std::mutex m_mutex;
    Progress m_progress;  ///< under m_mutex
    DryRunResult m_result;
};

/// "12:05" or "1:02:05"
QString runTime(double time_s);

}  // namespace sagara::ui::editor
