#pragma once

#include "ui/editor/FieldEditor.h"

class QCheckBox;
class QComboBox;
class QDateTimeEdit;
class QGridLayout;
class QHBoxLayout;
class QLineEdit;
class QPlainTextEdit;

/// The kinds of field that are not lists.
namespace sagara::ui::editor {

/// A line: text, id, number, position.
class LineEntry final : public FieldEditor {
    Q_OBJECT
public:
    LineEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent);
    void load() override;
    void focusEntry() override;

private:
    void take(const QString& text);
    void finish();
    QLineEdit* m_line;
    bool m_typing = false;  ///< since it was last left or entered: what stands there is not touched
};

class LongTextEntry final : public FieldEditor {
    Q_OBJECT
public:
    LongTextEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent);
    void load() override;
    void focusEntry() override;

private:
    QPlainTextEdit* m_text;
};

class FlagEntry final : public FieldEditor {
    Q_OBJECT
public:
    FlagEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent);
    void load() override;
    void focusEntry() override;

private:
    QCheckBox* m_box;
};

/// One of what there is. What is not there any more stays, and says so.
class ChoiceEntry final : public FieldEditor {
    Q_OBJECT
public:
    ChoiceEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent);
    void load() override;
    void focusEntry() override;

private:
    QComboBox* m_combo;
};

/// Check boxes for some of what there is.
class ReferencesEntry final : public FieldEditor {
    Q_OBJECT
public:
    ReferencesEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent);
    void load() override;
    void focusEntry() override;

private:
    void take();
    QGridLayout* m_grid;
    std::vector<QCheckBox*> m_boxes;
};

class NumbersEntry final : public FieldEditor {
    Q_OBJECT
public:
    NumbersEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent);
    void load() override;
    void focusEntry() override;

private:
    void take();
    QHBoxLayout* m_row;
    std::vector<QLineEdit*> m_lines;
    bool m_typing = false;
};

class UtcEntry final : public FieldEditor {
    Q_OBJECT
public:
    UtcEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent);
    void load() override;
    void focusEntry() override;

private:
    QDateTimeEdit* m_when;
    QLabel* m_local;
};

/// Shows what a combo box of options has, the value beside them when it is another.
void fillCombo(QComboBox& combo, const std::vector<Option>& options, bool optional, const QString& value);
/// Turns of the wheel go to the page unless the widget has the focus.
void keepWheelForPage(QWidget& widget);

}  // namespace sagara::ui::editor
