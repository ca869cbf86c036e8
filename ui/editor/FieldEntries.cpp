#include "ui/editor/FieldEntries.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "ui/editor/FieldText.h"
#include "ui/editor/ListEditor.h"
#include "ui/editor/PlaceEntry.h"

namespace sagara::ui::editor {

LineEntry::LineEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent)
    : FieldEditor(context, field, path, parent), m_line(new QLineEdit(this)) {
    m_line->setObjectName(QString::fromStdString(path));
    m_line->setToolTip(tip());
    m_line->setAccessibleName(field.label);
    if (field.optional) m_line->setPlaceholderText(words("none"));
    const bool narrow = field.kind == FieldKind::Number || field.kind == FieldKind::Integer;
    if (narrow) m_line->setMaximumWidth(110);
    auto* const row = new QHBoxLayout;
    row->addWidget(m_line, 1);
    if (!field.unit.isEmpty()) row->addWidget(new QLabel(field.unit, this));
    if (narrow) row->addStretch(1);
    box()->addLayout(row);
    connect(m_line, &QLineEdit::textEdited, this, &LineEntry::take);
    connect(m_line, &QLineEdit::editingFinished, this, &LineEntry::finish);
}

void LineEntry::finish() {
    if (!std::exchange(m_typing, false)) return;
    if (field().kind == FieldKind::Position && m_line->text() != shown(field(), value())) {
        if (auto place = typed(field(), m_line->text())) write(std::move(*place));
    }
    context().draft().endGoing();
    complain({});
    load();
}

void LineEntry::take(const QString& text) {
    m_typing = true;
    if (text.trimmed().isEmpty() && (field().optional || field().kind == FieldKind::Text)) {
        complain({});
        return write(field().optional ? Json() : Json(std::string()), true);
    }
    auto entry = typed(field(), text);
    complain(entry ? QString() : words("expected %1").arg(accepted(field())));
    // half a position is another one: it is taken when it is whole
    if (entry && field().kind != FieldKind::Position) write(std::move(*entry), true);
}

void LineEntry::load() {
    const QString text = shown(field(), value());
    if (m_line->text() == text) return;
    if (m_typing) return;
    m_line->setText(text);
    m_line->setCursorPosition(0);
}

void LineEntry::focusEntry() {
    m_line->setFocus();
    m_line->selectAll();
}

LongTextEntry::LongTextEntry(EditorContext& context, const Field& field, const std::string& path,
                             QWidget* parent)
    : FieldEditor(context, field, path, parent), m_text(new QPlainTextEdit(this)) {
    m_text->setObjectName(QString::fromStdString(path));
    m_text->setToolTip(tip());
    m_text->setTabChangesFocus(true);
    m_text->setMinimumHeight(field.key.ends_with("briefing") ? 220 : 70);
    if (!field.key.ends_with("briefing")) m_text->setMaximumHeight(90);
    box()->addWidget(m_text);
    connect(m_text, &QPlainTextEdit::textChanged, this,
            [this] { write(Json(m_text->toPlainText().toStdString()), true); });
}

void LongTextEntry::load() {
    const QString text = shown(field(), value());
    if (m_text->toPlainText() == text) return;
    const QSignalBlocker quiet(m_text);
    m_text->setPlainText(text);
}

void LongTextEntry::focusEntry() { m_text->setFocus(); }

FlagEntry::FlagEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent)
    : FieldEditor(context, field, path, parent), m_box(new QCheckBox(field.label, this)) {
    m_box->setObjectName(QString::fromStdString(path));
    m_box->setToolTip(tip());
    box()->addWidget(m_box);
    // false is written: "engage": false means something, and elsewhere it reads well
    connect(m_box, &QCheckBox::clicked, this,
            [this](bool on) { write(on || this->field().key == "engage" ? Json(on) : Json()); });
}

void FlagEntry::load() {
    const Json* flag = value();
    const bool unsaid = field().key == "engage";  // the loader's default
    m_box->setChecked(flag && flag->is_boolean() ? flag->get<bool>() : unsaid);
}

void FlagEntry::focusEntry() { m_box->setFocus(); }

NumbersEntry::NumbersEntry(EditorContext& context, const Field& field, const std::string& path,
                           QWidget* parent)
    : FieldEditor(context, field, path, parent), m_row(new QHBoxLayout) {
    box()->addLayout(m_row);
    m_row->setSpacing(4);
}

void NumbersEntry::load() {
    const std::size_t wanted = field().count ? field().count : context().shafts(path());
    const std::size_t there = value() && value()->is_array() ? value()->size() : 0;
    const std::size_t count = std::max(wanted, there);  // one too many is shown, and can be taken out
    if (m_lines.size() != count) {
        while (QLayoutItem* item = m_row->takeAt(0)) {
            delete item->widget();
            delete item;
        }
        m_lines.clear();
        for (std::size_t i = 0; i < count; ++i) {
            auto* const line = new QLineEdit(this);
            line->setObjectName(QString::fromStdString(join(path(), i)));
            line->setToolTip(tip());
            line->setMinimumWidth(38);
            line->setMaximumWidth(70);
            connect(line, &QLineEdit::textEdited, this, &NumbersEntry::take);
            connect(line, &QLineEdit::editingFinished, this, [this] {
                m_typing = false;
                context().draft().endGoing();
                complain({});
                load();
            });
            m_row->addWidget(line);
            m_lines.push_back(line);
        }
        m_row->addWidget(new QLabel(field().unit, this));
        m_row->addStretch(1);
    }
    Field one = field();
    one.kind = FieldKind::Number;
    for (std::size_t i = 0; i < count; ++i) {
        const Json* item = i < there ? &(*value())[i] : nullptr;
        const QString text = shown(one, item);
        if (!m_typing && m_lines[i]->text() != text) m_lines[i]->setText(text);
    }
}

void NumbersEntry::take() {
    m_typing = true;
    Json all = Json::array();
    Field one = field();
    one.kind = FieldKind::Number;
    for (QLineEdit* line : m_lines) {
        const auto entry = typed(one, line->text());
        if (!entry) {
            complain(words("expected %1 numbers, each %2").arg(m_lines.size()).arg(accepted(field())));
            return;
        }
        all.push_back(*entry);
    }
    complain({});
    write(std::move(all), true);
}

void NumbersEntry::focusEntry() {
    if (!m_lines.empty()) m_lines.front()->setFocus();
}

FieldEditor* makeFieldEditor(EditorContext& context, const Field& field, const std::string& path,
                             QWidget* parent) {
    switch (field.kind) {
        case FieldKind::Text:
        case FieldKind::Id:
        case FieldKind::Number:
        case FieldKind::Integer:
        case FieldKind::Position:
            return new LineEntry(context, field, path, parent);
        case FieldKind::LongText:
            return new LongTextEntry(context, field, path, parent);
        case FieldKind::Flag:
            return new FlagEntry(context, field, path, parent);
        case FieldKind::Choice:
        case FieldKind::Reference:
            return new ChoiceEntry(context, field, path, parent);
        case FieldKind::Place:
            return new PlaceEntry(context, field, path, parent);
        case FieldKind::Places:
            return new PlacesEntry(context, field, path, parent);
        case FieldKind::References:
            return new ReferencesEntry(context, field, path, parent);
        case FieldKind::Numbers:
            return new NumbersEntry(context, field, path, parent);
        case FieldKind::Utc:
            return new UtcEntry(context, field, path, parent);
        case FieldKind::List:
            return new ListEditor(context, field, path, parent);
    }
    return nullptr;
}

}  // namespace sagara::ui::editor
