#include "app/run/Console.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace sagara::run {

void tell(const std::string& message) { std::fprintf(stderr, "%s\n", message.c_str()); }
void print(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
}

double wallClock_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Progress::Progress() : m_last_s(wallClock_s()), m_terminal(isatty(STDERR_FILENO) != 0) {}

bool Progress::due() {
    constexpr double kEvery_s = 2.0;
    if (wallClock_s() - m_last_s < kEvery_s) return false;
    m_last_s = wallClock_s();
    return true;
}

void Progress::show(const std::string& line) {
    // on a terminal the line stands still; in a log each is one of its own
    if (m_terminal) std::fprintf(stderr, "\r%-70s", line.c_str());
    if (!m_terminal) std::fprintf(stderr, "%s\n", line.c_str());
    std::fflush(stderr);
    m_shown = true;
}

Progress::~Progress() {
    if (m_shown && m_terminal) std::fprintf(stderr, "\n");
}

}  // namespace sagara::run
