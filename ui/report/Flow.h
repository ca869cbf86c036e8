#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

namespace sagara::report {

/// One page: what its header says it is, and how its content is drawn, in mm. Refers to the RunReport it was
/// made from.
struct Sheet {
    QString title;
    std::function<void(QPainter&)> draw;
};

/// A piece of a page that is not torn apart: a paragraph, a row of a table, a box.
struct Block {
    double height_mm = 0.0;
    std::function<void(QPainter&, const QRectF&)> draw;  ///< into the full width and at least the height
    double before_mm = 0.0;  ///< distance from what is above; none at the top of a page
    bool keepWithNext = false;
    double growsTo_mm = 0.0;  ///< the last block may take the rest of its page, up to this height
    /// Repeated when the block comes first on a page: the head of its table.
    std::shared_ptr<const Block> heading = nullptr;
};

/// Lays blocks out from top to bottom, over as many sheets as it takes; from the second on the title says so.
std::vector<Sheet> flow(const QString& title, std::vector<Block> blocks, const QRectF& area);

/// Height of blocks on top of each other.
double stackedHeight_mm(const std::vector<Block>& blocks);
/// Blocks drawn on top of each other as one, for columns.
void drawStacked(QPainter& painter, const std::vector<Block>& blocks, const QRectF& area);

}  // namespace sagara::report
