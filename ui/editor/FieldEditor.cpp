#include "ui/editor/FieldEditor.h"

#include <QLabel>
#include <QVBoxLayout>

#include "ui/editor/FieldText.h"
#include "ui/theme/ThemeColours.h"

namespace sagara::ui::editor {

FieldEditor::FieldEditor(EditorContext& context, Field field, std::string path, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_field(std::move(field)),
      m_path(std::move(path)),
      m_box(new QVBoxLayout(this)),
      m_note(new QLabel(this)) {
    m_box->setContentsMargins(0, 0, 0, 0);
    m_box->setSpacing(2);
    m_note->setObjectName(QString::fromStdString(m_path + "#note"));
    m_note->setWordWrap(true);
    m_note->hide();
    setToolTip(tip());
    connect(&context, &EditorContext::coloursChanged, this, &FieldEditor::showNote);
}

QString FieldEditor::tip() const {
    const QString limits = accepted(m_field);
    return limits.isEmpty() ? m_field.hint : QStringLiteral("%1 (%2)").arg(m_field.hint, limits);
}

void FieldEditor::write(Json value, bool typing) {
    const QString what = words("change of %1").arg(m_field.label.toLower());
    const QString going = typing ? QString::fromStdString(m_path) : QString();
    if (!value.is_null()) return m_context.draft().set(m_path, std::move(value), what, going);
    m_context.draft().edit(
        what,
        [this](Json& document) {
            erase(document, m_path);
            const std::string outer = parentOf(m_path);
            const Json* left = editor::find(document, outer);
            if (!outer.empty() && !outer.ends_with(']') && left && left->is_object() && left->empty())
                erase(document, outer);
        },
        going);
}

void FieldEditor::complain(const QString& text) {
    m_complaint = text;
    showNote();
}

void FieldEditor::showProblems(const std::vector<core::config::Problem>& problems) {
    m_problem.clear();
    for (const auto& p : problems) {
        if (!within(p.path, m_path) || !m_problem.isEmpty()) continue;
        const QString found = QString::fromStdString(p.found), expected = QString::fromStdString(p.expected);
        m_problem = expected.isEmpty() ? found : words("%1; expected %2").arg(found, expected);
    }
    showNote();
}

void FieldEditor::showNote() {
    const QString text = m_complaint.isEmpty() ? m_problem : m_complaint;
    m_note->setVisible(!text.isEmpty());
    if (m_box->indexOf(m_note) < 0) m_box->addWidget(m_note);
    if (text.isEmpty()) return;
    const ThemeColours& c = themeColours(m_context.colours());
    m_note->setText(QStringLiteral("▲ ") + text);
    m_note->setStyleSheet(QStringLiteral("QLabel { background: %1; color: %2; border-radius: 3px; padding: 1px 5px; }")
                              .arg(c.caution.name(), c.onCaution.name()));
}

}  // namespace sagara::ui::editor
