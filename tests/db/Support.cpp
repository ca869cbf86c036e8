#include "Support.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QCoreApplication>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>

#include "db/sql/Query.h"

namespace sagara::db::test {
namespace {

namespace fs = std::filesystem;
constexpr uid_t kNobody = 65534;

/// Qt finds its SQL drivers through the application object.
class QtEnvironment final : public ::testing::Environment {
public:
    void SetUp() override { m_application.emplace(m_count, m_arguments); }
    void TearDown() override { m_application.reset(); }

private:
    char m_name[8] = "test_db";
    char* m_arguments[2] = {m_name, nullptr};
    int m_count = 1;
    std::optional<QCoreApplication> m_application;
};

[[maybe_unused]] const auto* const kQt = ::testing::AddGlobalTestEnvironment(new QtEnvironment);

std::string outcome(const std::function<void()>& action) {
    try {
        action();
        return "none";
    } catch (const DbError& error) {
        return kindPrefix(error.kind()) + error.what();
    }
}

[[noreturn]] void reportAsNobody(int pipe, const std::function<void()>& action) {
    std::string text = "cannot become an ordinary user";
    if (::getuid() != 0 || (::setgid(kNobody) == 0 && ::setuid(kNobody) == 0)) text = outcome(action);
    const bool written = ::write(pipe, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    ::_exit(written ? 0 : 1);
}

std::string readAll(int pipe) {
    std::string text;
    char buffer[512];
    for (ssize_t n = 0; (n = ::read(pipe, buffer, sizeof buffer)) > 0;) text.append(buffer, std::size_t(n));
    return text;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "sagara-db-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("mkdtemp " + name);
    m_path = fs::canonical(name);
    fs::permissions(m_path, fs::perms::all);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
}

std::string readBytes(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    EXPECT_TRUE(in) << file;
    return {std::istreambuf_iterator<char>(in), {}};
}

void writeBytes(const fs::path& file, std::string_view bytes) {
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    EXPECT_TRUE(out.flush()) << file;
}

std::map<std::string, std::string> contentsOf(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with("-shm")) files[name] = readBytes(entry.path());
    }
    return files;
}

void executeIn(const fs::path& file, const QString& sql) {
    Connection connection(file, Connection::Access::Create, kBusyTimeout);
    execute(connection, sql);
}

void executeScript(const fs::path& file, const fs::path& script) {
    Connection connection(file, Connection::Access::Create, kBusyTimeout);
    const QString text = QString::fromStdString(readBytes(script));
    for (const QString& sql : text.split(QStringLiteral(";\n"), Qt::SkipEmptyParts)) execute(connection, sql);
}

DbError errorOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const DbError& error) {
        return error;
    }
    ADD_FAILURE() << "nothing was thrown";
    return DbError(DbError::Kind::Other, "nothing was thrown");
}

std::string errorAsOrdinaryUser(const std::function<void()>& action) {
    int pipe[2];
    if (::pipe(pipe) != 0) return "no pipe";
    const pid_t child = ::fork();
    if (child == 0) reportAsNobody(pipe[1], action);
    ::close(pipe[1]);
    const std::string text = readAll(pipe[0]);
    ::close(pipe[0]);
    ::waitpid(child, nullptr, 0);
    return text;
}

std::string kindPrefix(DbError::Kind kind) { return std::to_string(static_cast<int>(kind)) + " "; }

NewDocument patrol(std::string text) {
    return {.key = "patrol51", .name = "Patrol vessel", .text = std::move(text), .origin = Origin::Shipped};
}

NewRun lesson(std::string recordingFile) {
    return {.person = {},
            .scenarioKey = "basic-navigation",
            .scenarioName = "Basic Navigation",
            .type = RunType::Assess,
            .level = 3,
            .seed = 7,
            .buildId = "0.1.0",
            .started = kMorning,
            .recordingFile = std::move(recordingFile)};
}

RunResult ended() {
    return {.status = RunStatus::Finished,
            .finished = kNoon,
            .simTime = {1'234'560'000},
            .stateHash = 0x0123456789abcdef};
}

Grade good() {
    return {.score = 87.5,
            .passed = true,
            .tasks = R"([{"id": "lines", "done": true}])",
            .deductions = R"([{"what": "speed", "points": 12.5}])",
            .advisory = true,
            .made = kNoon};
}

}  // namespace sagara::db::test
