#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sagara::ui {

struct VesselEntry {
    std::string id;
    std::string name;
    bool shipped = false;  ///< as Sagara brought it; else the school's own
    bool retired = false;  ///< hidden from lists; old recordings still replay
};

/// What is wrong, for a person; nothing when all is well.
using Trouble = std::optional<std::string>;

/// The vessels of this installation, as the pages here see them. Supplied by the station.
class VesselLibrary {
public:
    virtual ~VesselLibrary() = default;

    virtual std::vector<VesselEntry> all() const = 0;  ///< by name, retired ones too
    virtual std::string text(const std::string& id) const = 0;
    /// As the school's own, whatever it was before.
    virtual Trouble save(const std::string& id, const std::string& name, const std::string& text) = 0;
    virtual Trouble retire(const std::string& id) = 0;
    virtual Trouble restore(const std::string& id) = 0;
    /// Names of the scenarios that sail in her.
    virtual std::vector<std::string> usedBy(const std::string& id) const = 0;
    virtual bool isShippedToo(const std::string& id) const = 0;
    virtual Trouble backToShipped(const std::string& id) = 0;
    /// Where 3D models lie: the shipped folder, and the school's own, into which files are attached.
    virtual std::filesystem::path shippedModels() const = 0;
    virtual std::filesystem::path ownModels() const = 0;
    /// Why nothing can be saved; empty when it can.
    virtual std::string trouble() const = 0;
};

}  // namespace sagara::ui
