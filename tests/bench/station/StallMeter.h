#pragma once

#include <time.h>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace sagara::station {

/// How long the thread of the windows did not come back to its events: by the clock, and in time of the
/// processor, which other programs do not lengthen.
class StallMeter final : public QObject {
public:
    StallMeter() {
        begin();
        auto* const beat = new QTimer(this);
        beat->setTimerType(Qt::PreciseTimer);
        connect(beat, &QTimer::timeout, this, [this] { note(); });
        beat->start(kBeat_ms);
    }
    void begin() {
        m_gaps_ms.clear();
        m_most_cpu_ms = 0.0;
        m_cpu_ms = cpu_ms();
        m_clock.start();
    }
    std::string text() {
        note();
        std::sort(m_gaps_ms.begin(), m_gaps_ms.end());
        const auto at = [&](double q) {
            return m_gaps_ms[static_cast<std::size_t>(q * static_cast<double>(m_gaps_ms.size() - 1))];
        };
        char line[160];
        std::snprintf(
            line, sizeof line,
            "stalls of the windows: longest %.0f ms (%.0f ms of the processor), p99 %.0f ms, of %zu beats",
            at(1.0), m_most_cpu_ms, at(0.99), m_gaps_ms.size());
        return line;
    }

private:
    static constexpr int kBeat_ms = 5;

    static double cpu_ms() {
        timespec t{};
        ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
        return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
    }
    void note() {
        const double gap_ms = 1e-6 * static_cast<double>(m_clock.nsecsElapsed()) - kBeat_ms;
        m_clock.restart();
        m_gaps_ms.push_back(std::max(0.0, gap_ms));
        const double now_ms = cpu_ms();
        m_most_cpu_ms = std::max(m_most_cpu_ms, now_ms - m_cpu_ms);
        m_cpu_ms = now_ms;
    }

    QElapsedTimer m_clock;
    std::vector<double> m_gaps_ms;
    double m_cpu_ms = 0.0, m_most_cpu_ms = 0.0;
};

}  // namespace sagara::station
