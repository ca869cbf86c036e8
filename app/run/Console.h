#pragma once

#include <string>

namespace sagara::run {

/// One message to the person at the terminal, on standard error.
void tell(const std::string& message);
/// Standard output.
void print(const std::string& text);

/// A line of progress, not more often than every two seconds of the wall clock, and none for short work.
class Progress {
public:
    Progress();
    /// Whether a line is due; asking is cheap.
    bool due();
    void show(const std::string& line);
    ~Progress();

private:
    double m_last_s;
    bool m_terminal;
    bool m_shown = false;
};

/// Seconds of a steady clock.
double wallClock_s();

}  // namespace sagara::run
