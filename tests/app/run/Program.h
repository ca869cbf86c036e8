#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace sagara::run::test {

/// How a program ended and what it said.
struct Outcome {
    int exitCode = -1;  ///< -1 when a signal ended it
    int signal = 0;
    std::string out;
    std::string err;
};

/// sagara-sim in a process of its own, with its home in `folder`. Ends with the object at the latest.
class Program final {
public:
    /// `before` runs in the new process before the program does: for limits and rights.
    Program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
            const std::function<void()>& before = {});
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void kill();  ///< without a chance to tidy up
    Outcome wait();

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    using File = std::unique_ptr<std::FILE, Close>;
    File m_out{std::tmpfile()};
    File m_err{std::tmpfile()};
    pid_t m_pid = -1;
};

/// Waits for what a running program is to do; false when it did not in half a minute.
bool happens(const std::function<bool()>& what);

/// For `before`: files grow to so many bytes, then the disk seems to be full.
void limitFileSize(std::size_t most_bytes);
/// For `before`: read-only files and folders are so for root too.
void giveUpRightsOfRoot();

}  // namespace sagara::run::test
