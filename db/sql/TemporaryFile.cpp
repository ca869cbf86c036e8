#include "db/sql/TemporaryFile.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "db/sql/Failure.h"

namespace sagara::db {
namespace {

std::filesystem::path unusedName(const std::filesystem::path& target) {
    static std::atomic<unsigned> count{0};
    return target.string() + ".new-" + std::to_string(::getpid()) + "-" + std::to_string(++count);
}

void syncFile(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool done = file >= 0 && ::fsync(file) == 0;
    const int error = errno;
    if (file >= 0) ::close(file);
    if (done) return;
    const auto kind = error == ENOSPC || error == EDQUOT ? DbError::Kind::Full : DbError::Kind::Other;
    throw problem(kind, path, std::string("could not be written to the disk: ") + std::strerror(error));
}

/// std::filesystem::rename replaces a file that appears in this instant; QFile::rename may even empty it.
bool renameUnlessThere(const std::filesystem::path& from, const std::filesystem::path& to) {
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
    if (errno != EINVAL && errno != ENOSYS) return false;
    return ::link(from.c_str(), to.c_str()) ==
           0;  // a file system without that flag; our name goes with the object
}

}  // namespace

TemporaryFile::TemporaryFile(const std::filesystem::path& target)
    : m_target(target), m_path(unusedName(target)) {}

TemporaryFile::~TemporaryFile() {
    std::error_code ignored;
    for (const char* suffix : {"", "-journal", "-wal", "-shm"}) {
        std::filesystem::remove(m_path.string() + suffix, ignored);
    }
}

bool TemporaryFile::moveToNewTarget() const {
    syncFile(m_path);
    if (renameUnlessThere(m_path, m_target)) return true;
    if (errno == EEXIST) return false;
    throw problem(DbError::Kind::Other, m_target, std::string("could not be made: ") + std::strerror(errno));
}

void TemporaryFile::moveOverTarget() const {
    syncFile(m_path);
    std::error_code error;
    std::filesystem::rename(m_path, m_target, error);
    if (error) throw problem(DbError::Kind::Other, m_target, "could not be replaced: " + error.message());
}

}  // namespace sagara::db
