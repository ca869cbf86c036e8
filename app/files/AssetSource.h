#pragma once

#include <filesystem>
#include <vector>

#include "core/exercise/Documents.h"

namespace sagara::files {

/// The folder assets/ of this installation: beside the program where it is installed, else in the source tree
/// it was built from.
std::filesystem::path assetFolder();

/// The documents that are shipped, straight from assets/.
class AssetSource final : public core::DocumentSource {
public:
    explicit AssetSource(std::filesystem::path folder) : m_folder(std::move(folder)) {}

    std::optional<std::string> find(core::DocumentKind kind, const std::string& id) const override;
    std::vector<std::string> ids(core::DocumentKind kind) const;  ///< sorted

private:
    std::filesystem::path pathOf(core::DocumentKind kind, const std::string& id) const;
    std::filesystem::path m_folder;
};

}  // namespace sagara::files
