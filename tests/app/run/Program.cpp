#include "Program.h"

#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace sagara::run::test {
namespace {

[[noreturn]] void become(const std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    ::execv(argv[0], argv.data());
    ::_exit(127);
}

std::string contentOf(std::FILE* file) {
    std::string text;
    std::rewind(file);
    char buffer[4096];
    for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, file)) > 0;) text.append(buffer, n);
    return text;
}

}  // namespace

Program::Program(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                 const std::function<void()>& before) {
    std::vector<std::string> all{SAGARA_SIM};
    all.insert(all.end(), arguments.begin(), arguments.end());
    m_pid = ::fork();
    if (m_pid != 0) return;
    ::setenv("HOME", folder.c_str(), 1);
    ::setenv("XDG_RUNTIME_DIR", folder.c_str(), 1);
    ::unsetenv("XDG_DATA_HOME");
    ::dup2(::fileno(m_out.get()), STDOUT_FILENO);
    ::dup2(::fileno(m_err.get()), STDERR_FILENO);
    if (before) before();
    become(all);
}

Program::~Program() {
    if (m_pid <= 0) return;
    kill();
    ::waitpid(m_pid, nullptr, 0);
}

void Program::kill() { ::kill(m_pid, SIGKILL); }

Outcome Program::wait() {
    int status = 0;
    ::waitpid(m_pid, &status, 0);
    m_pid = -1;
    Outcome outcome;
    if (WIFEXITED(status)) outcome.exitCode = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
    outcome.out = contentOf(m_out.get());
    outcome.err = contentOf(m_err.get());
    return outcome;
}

bool happens(const std::function<bool()>& what) {
    for (int i = 0; i < 1500; ++i) {
        if (what()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
}

void limitFileSize(std::size_t most_bytes) {
    std::signal(SIGXFSZ, SIG_IGN);  // so that write(2) fails instead
    const rlimit limit{most_bytes, most_bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

void giveUpRightsOfRoot() {
    ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE);  // holds from the next execv on
}

}  // namespace sagara::run::test
