#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ui/debrief/DebriefPorts.h"

namespace sagara::replay {

/// Notes made while debriefing, kept beside the recording (X.sgr.notes.json), which itself never changes:
/// {"document": "notes", "version": 1, "notes": [{"time_s": 725.0, "text": "..."}]}. A file that cannot be
/// read is told when a note is to be added, and left as it is.
class NotesFile {
public:
    explicit NotesFile(const std::filesystem::path& recording);
    const std::filesystem::path& path() const { return m_path; }
    std::vector<ui::DebriefNote> read() const;  ///< in the order of time; none where there is no file
    std::optional<std::string> add(const ui::DebriefNote& note) const;

private:
    std::filesystem::path m_path;
};

}  // namespace sagara::replay
