#pragma once

#include <QAbstractTableModel>
#include <map>

#include "core/base/Problems.h"
#include "ui/editor/EditorContext.h"

namespace sagara::ui::editor {

/// MODEL: the rows of a list of the document. Numbers, words and positions can be changed in their cells.
class RowsModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    RowsModel(EditorContext& context, const ListSpec& spec, std::string path, QObject* parent);

    /// The document was changed.
    void refresh();
    void showProblems(const std::vector<core::config::Problem>& problems);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
    const Json* row(int index) const;
    const std::string& key(int column) const { return m_spec.columns[static_cast<std::size_t>(column)]; }
    QString cell(const Json& row, int column) const;

    EditorContext& m_context;
    const ListSpec& m_spec;
    std::string m_path;
    int m_count = 0;
    std::map<int, QString> m_problems;
};

}  // namespace sagara::ui::editor
