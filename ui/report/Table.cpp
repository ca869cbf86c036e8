#include "ui/report/Table.h"

#include <algorithm>
#include <utility>

namespace sagara::report {
namespace {

constexpr double kPad_mm = 0.72;     ///< above and below the text of a row
constexpr double kBetween_mm = 2.0;  ///< between the texts of two columns
const TextStyle kHeadStyle{7.5, colour::kQuiet, true};
const TextStyle kCellStyle{8.5};
const TextStyle kNoteStyle{7.0, colour::kQuiet};

/// A cell broken into lines, at its place across the row.
struct SetCell {
    TextBlock text;
    TextBlock note;
    double x_mm = 0.0;
    Qt::Alignment alignment;

    double height_mm() const { return text.height_mm() + note.height_mm(); }
    void draw(QPainter& painter, QPointF rowTopLeft) const {
        const QPointF at = rowTopLeft + QPointF(x_mm, kPad_mm);
        text.draw(painter, at, alignment);
        note.draw(painter, at + QPointF(0.0, text.height_mm()), alignment);
    }
};

SetCell setCell(const Table::Cell& cell, const Table::Column& column, double x_mm, TextStyle style) {
    style.bold = style.bold || cell.bold;
    if (cell.colour != colour::kInk) style.colour = cell.colour;
    const double room_mm = column.width_mm - kBetween_mm;
    SetCell set{TextBlock(cell.text, style, room_mm, 6), {}, x_mm, column.alignment};
    if (column.alignment & Qt::AlignRight) set.x_mm += kBetween_mm;
    if (!cell.note.isEmpty()) set.note = TextBlock(cell.note, kNoteStyle, room_mm, 6);
    return set;
}

std::vector<SetCell> setCells(const std::vector<Table::Cell>& cells,
                              const std::vector<Table::Column>& columns, const TextStyle& style) {
    std::vector<SetCell> set;
    double x_mm = 0.0;
    for (std::size_t i = 0; i < std::min(cells.size(), columns.size()); ++i) {
        set.push_back(setCell(cells[i], columns[i], x_mm, style));
        x_mm += columns[i].width_mm;
    }
    return set;
}

Block rowBlock(std::vector<SetCell> cells, const QPen& above, double width_mm) {
    Block block;
    for (const SetCell& cell : cells)
        block.height_mm = std::max(block.height_mm, cell.height_mm() + 2.0 * kPad_mm);
    block.draw = [cells = std::move(cells), above, width_mm](QPainter& painter, const QRectF& area) {
        if (above.style() != Qt::NoPen) {
            painter.setPen(above);
            painter.drawLine(area.topLeft(), area.topLeft() + QPointF(width_mm, 0.0));
        }
        for (const SetCell& cell : cells) cell.draw(painter, area.topLeft());
    };
    return block;
}

double widthOf_mm(const std::vector<Table::Column>& columns) {
    double width_mm = 0.0;
    for (const Table::Column& column : columns) width_mm += column.width_mm;
    return width_mm;
}

}  // namespace

Table::Table(std::vector<Column> columns) : m_columns(std::move(columns)) {
    std::vector<Cell> titles;
    for (const Column& column : m_columns) titles.push_back({column.title});
    Block head = rowBlock(setCells(titles, m_columns, kHeadStyle), QPen(Qt::NoPen), widthOf_mm(m_columns));
    m_head = std::make_shared<const Block>(head);
    head.keepWithNext = true;
    m_blocks.push_back(std::move(head));
}

Block Table::row(const std::vector<Cell>& cells, const QPen& above) const {
    Block block = rowBlock(setCells(cells, m_columns, kCellStyle), above, widthOf_mm(m_columns));
    block.heading = m_head;
    return block;
}

void Table::addRow(const std::vector<Cell>& cells) {
    const bool first = m_blocks.size() == 1;
    m_blocks.push_back(row(cells, first ? linePen(colour::kInk, 0.25) : linePen(colour::kRule, 0.15)));
}

void Table::addTotal(const std::vector<Cell>& cells) {
    m_blocks.back().keepWithNext = true;  // a total never stands alone
    m_blocks.push_back(row(cells, linePen(colour::kInk, 0.25)));
}

}  // namespace sagara::report
