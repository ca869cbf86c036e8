#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace sagara::run {

/// The file a recording grows in. Every chunk is handed to the system at once, so that a killed program loses
/// nothing that was written. When the disk fails the rest is dropped and `trouble` says why: the run itself
/// goes on.
class RecordingFile {
public:
    /// A new file; an old one of that name is replaced.
    static std::unique_ptr<RecordingFile> create(const std::filesystem::path& path, std::string& trouble);
    /// An old one, cut to its whole part, to go on writing.
    static std::unique_ptr<RecordingFile> append(const std::filesystem::path& path, std::size_t whole_bytes,
                                                 std::string& trouble);

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
