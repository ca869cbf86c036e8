#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace sagara::run {

/// The file a recording grows in. Every chunk is handed to the system at once, so that a killed program loses
/// nothing that was written. One program at a time may write it. When the disk fails the rest is dropped and
/// `trouble` says why: the run itself goes on.
class RecordingFile {
public:
    /// The file of that name, made when it is not there, cut to so many bytes: 0 for a new run, its whole
    /// part for one that is taken up again. Null, and the trouble told, when it cannot be written.
    static std::unique_ptr<RecordingFile> open(const std::filesystem::path& path, std::size_t whole_bytes,
                                               std::string& trouble);

    /// Whether a program, this one too, has it open for that.
    static bool isBeingWritten(const std::filesystem::path& path);

    void write(std::span<const std::byte> bytes);
    const std::string& trouble() const { return m_trouble; }
    const std::filesystem::path& path() const { return m_path; }

private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    RecordingFile(std::filesystem::path path, std::FILE* file) : m_path(std::move(path)), m_file(file) {}

    std::filesystem::path m_path;
    std::unique_ptr<std::FILE, Close> m_file;
    std::string m_trouble;
};

}  // namespace sagara::run
