#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "ui/report/Flow.h"
#include "ui/report/Text.h"

namespace sagara::report {

/// A table as blocks, so that it can break between rows over pages and its head is repeated. Cells wrap.
class Table {
public:
    struct Column {
        QString title;
        double width_mm = 0.0;
        Qt::Alignment alignment = Qt::AlignLeft;
    };
    struct Cell {
        QString text = {};
        QString note = {};  ///< second line, small and quiet
        bool bold = false;
        QColor colour = colour::kInk;
    };

    explicit Table(std::vector<Column> columns);
    void addRow(const std::vector<Cell>& cells);
    /// A last row set off by a stronger line.
    void addTotal(const std::vector<Cell>& cells);
    /// Head and rows. Empties the table.
    std::vector<Block> takeBlocks() { return std::move(m_blocks); }

private:
    Block row(const std::vector<Cell>& cells, const QPen& above) const;

    std::vector<Column> m_columns;
    std::shared_ptr<const Block> m_head;
    std::vector<Block> m_blocks;
};

}  // namespace sagara::report
