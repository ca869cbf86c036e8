#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/exercise/Documents.h"

namespace sagara::ui::editor {

/// The documents of this installation as the editor needs them. Called from the window's thread; outlives the
/// editor.
class EditorPort {
public:
    struct Entry {
        std::string id;
        std::string name;
        bool shipped = true;  ///< and not changed by the user
    };
    virtual ~EditorPort() = default;

    /// By name.
    virtual std::vector<Entry> list(core::DocumentKind kind) const = 0;
    virtual std::optional<std::string> text(core::DocumentKind kind, const std::string& id) const = 0;
    /// Where hulls made for the sea are kept; null: nowhere.
    virtual std::shared_ptr<core::SeaHulls> hulls() const { return nullptr; }
    /// Stores a scenario as the user's own, in place of what has this id. What went wrong, for the person.
    virtual std::optional<std::string> save(const std::string& id, const std::string& name,
                                            const std::string& text) = 0;
};

}  // namespace sagara::ui::editor
