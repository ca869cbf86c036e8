#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Result.h"

namespace sagara::ui {

/// A file that goes with a vessel: her 3D model, its textures.
struct AttachedFile {
    std::string path;  ///< below the models folder
    std::string bytes;
};

/// A vessel as one file, to carry to another school: {"document": "vessel-export", "version": 1, "vessel":
/// {the document}, "files": [{"path", "base64"}]}. Only files of the school's own models folder travel;
/// shipped models are everywhere. A bare vessel document is read too.
struct VesselFile {
    std::string text;  ///< the vessel document
    std::vector<AttachedFile> files;
};
std::string vesselFileText(const VesselFile& file);
/// The error is for a person: every problem of the document.
core::Result<VesselFile, std::string> readVesselFile(const std::string& name, const std::string& text);

/// The files of the folder that a model of the school's own lies in; none for a shipped or missing model.
std::vector<AttachedFile> attachedFiles(const std::string& vesselText,
                                        const std::filesystem::path& ownModels);
/// Writes them below the folder; the error names the file.
std::optional<std::string> writeAttached(const std::vector<AttachedFile>& files,
                                         const std::filesystem::path& ownModels);

/// A model file with what it names beside it (materials, textures), as attached files in the folder
/// "attached/ID". The error is for a person.
core::Result<std::vector<AttachedFile>, std::string> gatherModel(const std::filesystem::path& model,
                                                                 const std::string& vesselId);

/// The document under another id and name; for copies.
std::string renamed(const std::string& vesselText, const std::string& id, const std::string& name);

}  // namespace sagara::ui
