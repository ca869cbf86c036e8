#pragma once

#include <QWidget>
#include <memory>

#include "core/base/Problems.h"
#include "ui/editor/EditorContext.h"

class QLabel;
class QVBoxLayout;

namespace sagara::ui::editor {

/// VIEW of one member of the document: shows it, and writes what is typed. Its objectName, or that of the
/// widget typed into, is the path of the member.
class FieldEditor : public QWidget {
    Q_OBJECT
public:
    FieldEditor(EditorContext& context, Field field, std::string path, QWidget* parent);

    const std::string& path() const { return m_path; }
    const Field& field() const { return m_field; }
    /// Shows what the document has now; what is just being typed stays.
    virtual void load() = 0;
    /// Takes the problems at its path; the rest it leaves alone.
    virtual void showProblems(const std::vector<core::config::Problem>& problems);
    /// The innermost editor of a path in this one; rows on the way are chosen.
    virtual FieldEditor* reveal(const std::string&) { return this; }
    virtual void focusEntry() { setFocus(); }

protected:
    EditorContext& context() const { return m_context; }
    const Json* value() const { return m_context.draft().at(m_path); }
    /// Null removes an optional member, and the object it was the last of.
    void write(Json value, bool typing = false);
    /// Says at the field what is accepted; empty: all is well.
    void complain(const QString& text);
    QVBoxLayout* box() const { return m_box; }
    QString tip() const;

private:
    void showNote();

    EditorContext& m_context;
    Field m_field;
    std::string m_path;
    QVBoxLayout* m_box;
    QLabel* m_note;
    QString m_complaint;
    QString m_problem;
};

/// The editor of a field's kind.
FieldEditor* makeFieldEditor(EditorContext& context, const Field& field, const std::string& path, QWidget* parent);

}  // namespace sagara::ui::editor
