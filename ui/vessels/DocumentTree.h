#pragma once

#include <QTreeWidget>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/base/Problems.h"
#include "ui/theme/PaletteName.h"

namespace sagara::ui {

/// A document (JSON) as a tree of groups and fields: name, value, unit, and what is known of it: source and
/// quality of a group, or what is wrong with a field. To read, or to edit field by field.
class DocumentTree final : public QTreeWidget {
    Q_OBJECT

public:
    enum class Use { Read, Edit };
    enum Column { Name, Value, Unit, About };

    explicit DocumentTree(Use use, QWidget* parent = nullptr);
    ~DocumentTree() override;

    /// The place in the tree is kept where the document has it again.
    void setDocument(const std::string& text);
    std::string text() const;
    void setProblems(const core::config::Problems& problems);
    void setColours(PaletteName name);
    /// Shows only fields whose name or value has this in it, with the groups they are in.
    void setFilter(const QString& text);

    std::string currentPath() const;  ///< as in Problem::path
    bool choose(const std::string& path);
    /// Of lists: another one like the chosen item after it; the item taken away.
    bool canAdd() const;
    bool addLikeCurrent();
    bool canRemove() const;
    bool removeCurrent();
    /// The item at a path, or null.
    QTreeWidgetItem* itemAt(const std::string& path) const;

Q_SIGNALS:
    void edited();

private:
    void fill(QTreeWidgetItem* parent, const std::string& key, const nlohmann::ordered_json& value,
              const std::string& pointer, const std::string& path);
    void take(QTreeWidgetItem* item);
    QTreeWidgetItem* listItem() const;

    Use m_use;
    PaletteName m_colours = PaletteName::Day;
    std::unique_ptr<nlohmann::ordered_json> m_json;
    std::vector<std::string> m_problemPaths;
    bool m_filling = false;
};

}  // namespace sagara::ui
