#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/Result.h"

namespace sagara::db {

/// Where an installation keeps its database and its recordings. The folder and `recordings/` exist and may be
/// written.
class DataFolder final {
public:
    /// `given` (the option --data), else $XDG_DATA_HOME/sagara, else ~/.local/share/sagara. The error is a
    /// message for the person who chose the folder.
    static core::Result<DataFolder, std::string> open(const std::optional<std::filesystem::path>& given);

    const std::filesystem::path& root() const { return m_root; }
    std::filesystem::path database() const { return m_root / "sagara.db"; }
    std::filesystem::path recordings() const { return m_root / "recordings"; }

    /// How the database names a file: relative when it lies in this folder, so that the folder may be moved.
    std::string nameOf(const std::filesystem::path& file) const;
    std::filesystem::path pathOf(const std::string& name) const { return m_root / name; }

private:
    explicit DataFolder(std::filesystem::path root) : m_root(std::move(root)) {}

    std::filesystem::path m_root;  ///< absolute, links resolved
};

}  // namespace sagara::db
