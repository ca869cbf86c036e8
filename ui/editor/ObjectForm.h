#pragma once

#include "ui/editor/FieldEditor.h"

class QFormLayout;

namespace sagara::ui::editor {

/// VIEW of the members of one object of the document, a line each.
class ObjectForm final : public QWidget {
    Q_OBJECT
public:
    /// `path` "" is the document.
    ObjectForm(EditorContext& context, const std::vector<Field>& fields, std::string path, QWidget* parent);

    void load();
    void showProblems(const std::vector<core::config::Problem>& problems);
    /// Null when the path is none of this form's.
    FieldEditor* reveal(const std::string& path);
    /// A widget above the fields.
    void addAbove(QWidget* widget);

private:
    std::string m_path;
    QFormLayout* m_rows;
    std::vector<FieldEditor*> m_editors;
};

}  // namespace sagara::ui::editor
