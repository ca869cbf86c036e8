#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace sagara::ui {

/// What an exhibition of many hours looks like from inside.
struct DemoFigures {
    double up_s = 0.0;
    std::uint64_t frames = 0;  ///< pictures asked for
    std::uint64_t resets = 0;
    std::uint64_t unequal = 0;     ///< resets whose first State was another one: must stay 0
    double longestStall_ms = 0.0;  ///< between two pictures since the last line
    int lesson = 0;
    const char* phase = "";
};

/// Memory of this process that is really there, in kB; 0 where it cannot be told.
std::int64_t residentMemory_kB();

/// A line every so often in a file of comma-separated values; a file that cannot be written is left alone.
class DemoLog final {
public:
    DemoLog(const std::filesystem::path& file, double every_s);
    void note(const DemoFigures& figures);
    /// True when a line was written: the figures "since the last line" begin anew.
    bool noteIfDue(const DemoFigures& figures);

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> m_file;
    double m_every_s;
    double m_due_s = 0.0;
};

}  // namespace sagara::ui
