#pragma once

#include <QString>
#include <QWidget>
#include <atomic>
#include <functional>

namespace sagara::ui::roster {

/// Between a long piece of work and the window that waits for it; used by two threads.
class JobControl final {
public:
    void setPercent(int percent) { m_percent = percent; }
    int percent() const { return m_percent; }
    void cancel() { m_cancelled = true; }
    bool cancelled() const { return m_cancelled; }

private:
    std::atomic<int> m_percent{0};
    std::atomic<bool> m_cancelled{false};
};

/// Work for another thread; touches nothing of the interface. Looks at `cancelled` now and then. Gives the
/// trouble, or an empty text.
using Job = std::function<QString(JobControl&)>;

/// Does the work in another thread behind a progress bar with a cancel button. `done` is called in this
/// thread, with the trouble or an empty text, unless it was cancelled or `parent` is gone by then.
void runJob(QWidget* parent, const QString& title, Job job, std::function<void(const QString&)> done);

/// Asks where the report is to be written and writes it there; tells how it went in a box over `parent`.
void writeReport(QWidget* parent, const QString& suggestedName, std::function<Job(const QString& file)> make);

}  // namespace sagara::ui::roster
