#include "ui/editor/ObjectForm.h"

#include <QFormLayout>
#include <QLabel>
#include <algorithm>

namespace sagara::ui::editor {

using core::config::Problem;

ObjectForm::ObjectForm(EditorContext& context, const std::vector<Field>& fields, std::string path, QWidget* parent)
    : QWidget(parent), m_path(std::move(path)), m_rows(new QFormLayout(this)) {
    m_rows->setContentsMargins(0, 0, 0, 0);
    m_rows->setVerticalSpacing(6);
    m_rows->setRowWrapPolicy(QFormLayout::DontWrapRows);
    m_rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    for (const Field& field : fields) {
        FieldEditor* const editor = makeFieldEditor(context, field, join(m_path, field.key), this);
        m_editors.push_back(editor);
        const bool wide = field.kind == FieldKind::List || field.kind == FieldKind::LongText;
        if (field.kind == FieldKind::List && fields.size() == 1) {
            m_rows->addRow(editor);
        } else if (wide) {
            auto* const heading = new QLabel(field.label, this);
            heading->setToolTip(field.hint);
            QFont font = heading->font();
            font.setBold(field.kind == FieldKind::List);
            heading->setFont(font);
            m_rows->addRow(heading);
            m_rows->addRow(editor);
        } else {
            auto* const label = new QLabel(field.kind == FieldKind::Flag ? QString() : field.label, this);
            label->setToolTip(field.hint);
            label->setWordWrap(true);
            label->setMinimumWidth(104);
            label->setMaximumWidth(130);
            m_rows->addRow(label, editor);
        }
    }
}

void ObjectForm::load() {
    for (FieldEditor* editor : m_editors) editor->load();
}

void ObjectForm::showProblems(const std::vector<Problem>& problems) {
    std::vector<Problem> mine;
    for (Problem p : problems) {
        const auto at = [&](const FieldEditor* e) { return within(p.path, e->path()); };
        if (std::none_of(m_editors.begin(), m_editors.end(), at) && p.path != m_path) {
            // of an object a field lies in, such as "when": said at its first field
            const auto in = std::find_if(m_editors.begin(), m_editors.end(),
                                         [&](const FieldEditor* e) { return within(e->path(), p.path); });
            if (in != m_editors.end()) p.path = (*in)->path();
        }
        mine.push_back(std::move(p));
    }
    for (FieldEditor* editor : m_editors) editor->showProblems(mine);
}

FieldEditor* ObjectForm::reveal(const std::string& path) {
    for (FieldEditor* editor : m_editors)
        if (within(path, editor->path())) return editor->reveal(path);
    for (FieldEditor* editor : m_editors)
        if (within(editor->path(), path)) return editor;
    return nullptr;
}

void ObjectForm::addAbove(QWidget* widget) { m_rows->insertRow(0, widget); }

}  // namespace sagara::ui::editor
