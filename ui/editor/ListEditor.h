#pragma once

#include "ui/editor/FieldEditor.h"

class QComboBox;
class QTableView;
class QToolButton;

namespace sagara::ui::editor {

class ObjectForm;
class RowsModel;

/// VIEW of a list: a table, buttons, and below it the form of the chosen row. objectNames: the table's is the
/// path of the list, a button's "PATH.add" (insert, copy, delete, up, down), the row's kind "PATH[i]#kind".
class ListEditor final : public FieldEditor {
    Q_OBJECT
public:
    ListEditor(EditorContext& context, const Field& field, const std::string& path, QWidget* parent);

    void load() override;
    void showProblems(const std::vector<core::config::Problem>& problems) override;
    FieldEditor* reveal(const std::string& path) override;
    void focusEntry() override;
    int chosenRow() const { return m_row; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    const ListSpec& spec() const { return *field().list; }
    std::string rowPath(int row) const { return join(path(), static_cast<std::size_t>(row)); }
    void addButtons();
    void addKinds(QToolButton& button);
    void add(const Variant* variant, int before);
    Json newRow(const Variant* variant) const;
    void insert(Json row, int before, const QString& what);
    void copy();
    void remove();
    void move(int by);
    void choose(int row);
    void showRow();
    void takeKind();
    void fitTable();

    RowsModel* m_model;
    QTableView* m_table;
    std::vector<QToolButton*> m_ofRow;  ///< buttons that need a row
    QWidget* m_rowBox;
    QLabel* m_rowTitle;
    QComboBox* m_kind;
    ObjectForm* m_form = nullptr;
    const Variant* m_formVariant = nullptr;
    int m_formRow = -1;
    int m_row = -1;
    std::vector<core::config::Problem> m_problems;
};

}  // namespace sagara::ui::editor
