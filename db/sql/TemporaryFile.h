#pragma once

#include <filesystem>

namespace sagara::db {

/// A name beside `target` for a database in the making. Whatever is still there at the end is removed.
class TemporaryFile final {
public:
    explicit TemporaryFile(const std::filesystem::path& target);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::filesystem::path& path() const { return m_path; }

    /// Makes it the target, in one step, bytes on the disk first. False when there is one already.
    bool moveToNewTarget() const;
    void moveOverTarget() const;

private:
    std::filesystem::path m_target;
    std::filesystem::path m_path;
};

}  // namespace sagara::db
