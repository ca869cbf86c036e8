#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <cstdint>
#include <vector>

#include "ui/theme/PaletteName.h"

class QSortFilterProxyModel;
class QStyledItemDelegate;

namespace sagara::ui::roster {

/// How a cell is meant: quiet words, or a coloured field with its word in it.
enum class Tone { Plain, Quiet, Good, Bad, Attention };

struct Cell {
    Cell(QString words = {}, Tone meant = Tone::Plain) : text(std::move(words)), tone(meant) {}
    QString text;
    Tone tone = Tone::Plain;
    QVariant order;  ///< what it is sorted by; else its text
    QString tip = {};
};

struct Column {
    QString title;
    QString tip = {};
    bool number = false;   ///< set to the right
    bool stretch = false;  ///< takes what room is left
};

/// A row and whose it is.
struct Row {
    std::int64_t id = 0;
    std::vector<Cell> cells;
};

/// MODEL: rows of words, whole.
class RowsModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    static constexpr int kOrderRole = Qt::UserRole;
    static constexpr int kToneRole = Qt::UserRole + 1;

    explicit RowsModel(std::vector<Column> columns, QObject* parent = nullptr);
    void show(std::vector<Row> rows);
    std::int64_t idOf(int row) const { return m_rows[static_cast<std::size_t>(row)].id; }
    const std::vector<Column>& columns() const { return m_columns; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<Column> m_columns;
    std::vector<Row> m_rows;
};

/// Draws cells by their tone (kToneRole), for tables of other models, too.
QStyledItemDelegate* toneDelegate(PaletteName palette, QObject* parent);

/// VIEW: such rows, sorted by a click on a header, searched by words; says what to do when there are none.
class RowsView final : public QTableView {
    Q_OBJECT

public:
    RowsView(const QString& name, std::vector<Column> columns, QWidget* parent = nullptr);

    void show(std::vector<Row> rows);  ///< keeps the selection by id
    void setEmptyText(const QString& text);
    void setSearch(const QString& words);  ///< all of them somewhere in the row
    void setColours(PaletteName palette);
    int shownRows() const;
    std::vector<std::int64_t> shownIds() const;  ///< as sorted and searched
    std::vector<std::int64_t> selectedIds() const;
    std::int64_t selectedId() const;  ///< 0 unless one row is selected
    void select(std::int64_t id);
    RowsModel& rows() { return *m_model; }
    using QTableView::show;

Q_SIGNALS:
    void chosen();                 ///< the selection changed
    void opened(std::int64_t id);  ///< double click or Enter

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void fitColumns();

    RowsModel* m_model;
    QSortFilterProxyModel* m_sorted;
    QString m_emptyText;
};

}  // namespace sagara::ui::roster
