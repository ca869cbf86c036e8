#include "render/wall/ChannelProcess.h"

#include <sys/prctl.h>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTimer>
#include <algorithm>
#include <csignal>

#include "render/link/SteadyClock.h"

namespace sagara::wall {
namespace {

constexpr std::int64_t kLongEnough_us = 5'000'000;  ///< having run so long it was no false start
constexpr int kFirstPause_ms = 250, kLongestPause_ms = 3'000;

QStringList listOf(const std::vector<std::string>& texts) {
    QStringList list;
    for (const std::string& text : texts) list.push_back(QString::fromStdString(text));
    return list;
}

}  // namespace

class ChannelProcess::Impl {
public:
    Impl(std::string name, const Command& command, std::function<void(const std::string&)> tell)
        : m_name(std::move(name)), m_tell(std::move(tell)) {
        m_process.setProgram(QString::fromStdString(command.program));
        m_process.setArguments(listOf(command.arguments));
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const auto& [key, value] : command.environment)
            environment.insert(QString::fromStdString(key), QString::fromStdString(value));
        m_process.setProcessEnvironment(environment);
        m_process.setProcessChannelMode(QProcess::SeparateChannels);
        m_process.setStandardOutputFile(QProcess::nullDevice());
        // A station that is killed leaves no channels behind, not even frozen ones.
        m_process.setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGKILL); });
        m_again.setSingleShot(true);
        QObject::connect(&m_again, &QTimer::timeout, &m_process, [this] { start(); });
        QObject::connect(&m_process, &QProcess::readyReadStandardError, &m_process, [this] { readErrors(); });
        QObject::connect(&m_process, &QProcess::finished, &m_process,
                         [this](int code, QProcess::ExitStatus status) { ended(code, status); });
        QObject::connect(&m_process, &QProcess::errorOccurred, &m_process,
                         [this](QProcess::ProcessError error) {
                             if (error != QProcess::FailedToStart) return;
                             m_tell(m_name + ": cannot start " + m_process.program().toStdString() + ": " +
                                    m_process.errorString().toStdString());
                             startLater();
                         });
    }
    ~Impl() {
        m_process.disconnect();
        m_process.kill();
        m_process.waitForFinished(2000);
    }

    void start() {
        if (m_stopping || m_process.state() != QProcess::NotRunning) return;
        ++m_starts;
        m_lastLine.clear();
        m_started_us = link::steadyClock_us();
        m_process.start();
    }
    void restart() {
        if (m_stopping) return;
        m_wanted = true;
        if (m_process.state() == QProcess::NotRunning) {
            if (!m_again.isActive()) startLater();
        } else {
            m_process.kill();
        }
    }
    void stop(int patience_ms) {
        m_stopping = true;
        m_again.stop();
        if (m_process.state() == QProcess::NotRunning) return;
        if (!m_process.waitForFinished(patience_ms)) m_process.kill();
        m_process.waitForFinished(2000);
    }
    std::int64_t processId() const { return m_process.processId(); }
    int starts() const { return m_starts; }

private:
    void ended(int code, QProcess::ExitStatus status) {
        readErrors();
        if (m_stopping) return;
        if (!std::exchange(m_wanted, false)) {
            m_tell(m_name +
                   (status == QProcess::CrashExit ? " was killed or crashed"
                                                  : " ended with code " + std::to_string(code)) +
                   (m_lastLine.empty() ? "" : ": " + m_lastLine));
        }
        startLater();
    }
    void startLater() {
        const bool falseStart = link::steadyClock_us() - m_started_us < kLongEnough_us;
        m_pause_ms = falseStart ? std::min(kLongestPause_ms, std::max(kFirstPause_ms, 2 * m_pause_ms)) : 0;
        // The first false start may be chance: a channel killed twice in a row is back at once.
        m_again.start(m_pause_ms == kFirstPause_ms ? 0 : m_pause_ms);
    }
    void readErrors() {
        m_process.setReadChannel(QProcess::StandardError);
        while (m_process.canReadLine() ||
               (m_process.state() == QProcess::NotRunning && m_process.bytesAvailable())) {
            const std::string line = m_process.readLine(4096).trimmed().toStdString();
            if (!line.empty()) m_lastLine = line;
        }
    }

    std::string m_name;
    std::function<void(const std::string&)> m_tell;
    QProcess m_process;
    QTimer m_again;
    std::string m_lastLine;
    std::int64_t m_started_us = 0;
    int m_pause_ms = 0;
    int m_starts = 0;
    bool m_wanted = false;  ///< its end was: restart() is under way
    bool m_stopping = false;
};

ChannelProcess::ChannelProcess(std::string name, const Command& command,
                               std::function<void(const std::string&)> tell)
    : m_impl(std::make_unique<Impl>(std::move(name), command, std::move(tell))) {}
ChannelProcess::~ChannelProcess() = default;
void ChannelProcess::start() { m_impl->start(); }
void ChannelProcess::restart() { m_impl->restart(); }
void ChannelProcess::stop(int patience_ms) { m_impl->stop(patience_ms); }
std::int64_t ChannelProcess::processId() const { return m_impl->processId(); }
int ChannelProcess::starts() const { return m_impl->starts(); }

}  // namespace sagara::wall
