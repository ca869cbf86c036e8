#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "render/link/Messages.h"

namespace sagara::run {

/// Puts the pictures of one frame side by side, in the order of the channels, into FOLDER/wall-0001.png and
/// so on. Fewer where a channel was not in step.
class WallPictures {
public:
    WallPictures(std::filesystem::path folder, std::vector<std::string> channels)
        : m_folder(std::move(folder)), m_channels(std::move(channels)) {}

    void add(const std::string& channel, const link::Picture& picture);
    /// Writes what has come of the frame begun. Nothing when all is well; else what is wrong, for people.
    std::optional<std::string> write();
    int written() const { return m_written; }

private:
    std::filesystem::path m_folder;
    std::vector<std::string> m_channels;
    std::map<std::string, link::Picture> m_pictures;
    int m_written = 0;
};

}  // namespace sagara::run
