#include "app/run/RecordingFile.h"

#include <cerrno>
#include <cstring>

namespace sagara::run {
namespace fs = std::filesystem;
namespace {

std::string because(const fs::path& path) {
    return path.string() + ": the recording cannot be written (" + std::strerror(errno) + ")";
}

}  // namespace

std::unique_ptr<RecordingFile> RecordingFile::create(const fs::path& path, std::string& trouble) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (!file) trouble = because(path);
    return file ? std::unique_ptr<RecordingFile>(new RecordingFile(path, file)) : nullptr;
}

std::unique_ptr<RecordingFile> RecordingFile::append(const fs::path& path, std::size_t whole_bytes,
                                                     std::string& trouble) {
    std::error_code failed;
    fs::resize_file(path, whole_bytes, failed);
    errno = failed.value();
    std::FILE* file = failed ? nullptr : std::fopen(path.c_str(), "ab");
    if (!file) trouble = because(path);
    return file ? std::unique_ptr<RecordingFile>(new RecordingFile(path, file)) : nullptr;
}

void RecordingFile::write(std::span<const std::byte> bytes) {
    if (!m_trouble.empty()) return;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), m_file.get()) == bytes.size();
    if (!written || std::fflush(m_file.get()) != 0) m_trouble = because(m_path);
}

}  // namespace sagara::run
