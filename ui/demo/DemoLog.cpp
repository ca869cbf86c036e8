#include "ui/demo/DemoLog.h"

#include <unistd.h>

namespace sagara::ui {

std::int64_t residentMemory_kB() {
    std::FILE* const file = std::fopen("/proc/self/statm", "r");
    if (file == nullptr) return 0;
    long all_pages = 0, resident_pages = 0;
    const int read = std::fscanf(file, "%ld %ld", &all_pages, &resident_pages);
    std::fclose(file);
    return read == 2 ? resident_pages * (::sysconf(_SC_PAGESIZE) / 1024) : 0;
}

DemoLog::DemoLog(const std::filesystem::path& file, double every_s) : m_every_s(every_s) {
    if (file.empty()) return;
    m_file.reset(std::fopen(file.c_str(), "w"));
    if (m_file) std::fputs("up_s,rss_kB,frames,resets,unequal,longest_stall_ms,lesson,phase\n", m_file.get());
}

void DemoLog::note(const DemoFigures& f) {
    if (!m_file) return;
    std::fprintf(m_file.get(), "%.0f,%lld,%llu,%llu,%llu,%.0f,%d,%s\n", f.up_s,
                 static_cast<long long>(residentMemory_kB()), static_cast<unsigned long long>(f.frames),
                 static_cast<unsigned long long>(f.resets), static_cast<unsigned long long>(f.unequal),
                 f.longestStall_ms, f.lesson, f.phase);
    std::fflush(m_file.get());
}

bool DemoLog::noteIfDue(const DemoFigures& figures) {
    if (figures.up_s < m_due_s) return false;
    m_due_s = figures.up_s + m_every_s;
    note(figures);
    return true;
}

}  // namespace sagara::ui
