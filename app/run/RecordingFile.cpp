#include "app/run/RecordingFile.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace sagara::run {
namespace fs = std::filesystem;
namespace {

std::string because(const fs::path& path) {
    return path.string() + ": the recording cannot be written (" + std::strerror(errno) + ")";
}

}  // namespace

std::unique_ptr<RecordingFile> RecordingFile::open(const fs::path& path, std::size_t whole_bytes,
                                                   std::string& trouble) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    std::unique_ptr<RecordingFile> file;
    if (descriptor >= 0) file.reset(new RecordingFile(path, ::fdopen(descriptor, "ab")));
    // A file system without locks and a device without a length are no trouble.
    if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        trouble = path.string() + ": another program is writing this recording; wait until it has ended";
        return nullptr;
    }
    if (descriptor < 0 ||
        (fs::is_regular_file(path) && ::ftruncate(descriptor, static_cast<off_t>(whole_bytes)))) {
        trouble = because(path);
        return nullptr;
    }
    return file;
}

bool RecordingFile::isBeingWritten(const fs::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return false;
    const bool locked = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(descriptor);
    return locked;
}

void RecordingFile::write(std::span<const std::byte> bytes) {
    if (!m_trouble.empty()) return;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), m_file.get()) == bytes.size();
    if (!written || std::fflush(m_file.get()) != 0) m_trouble = because(m_path);
}

}  // namespace sagara::run
