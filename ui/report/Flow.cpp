#include "ui/report/Flow.h"

#include <algorithm>

#include "ui/report/Text.h"

namespace sagara::report {
namespace {

struct Placed {
    Block block;
    QRectF area;
};
using Placement = std::vector<Placed>;

/// Fills pages with blocks. Owns nothing but the page it is on.
class Filler {
public:
    explicit Filler(const QRectF& area) : m_area(area), m_y_mm(area.top()) {}

    void add(const Block& block, double needed_mm) {
        const double gap_mm = m_pages.back().empty() ? 0.0 : block.before_mm;
        if (!m_pages.back().empty() && m_y_mm + gap_mm + needed_mm > m_area.bottom()) {
            m_pages.emplace_back();
            m_y_mm = m_area.top();
            if (block.heading) put(*block.heading, 0.0);
            put(block, 0.0);
        } else {
            put(block, gap_mm);
        }
    }
    std::vector<Placement> finish() {
        growLast();
        return std::move(m_pages);
    }

private:
    void put(const Block& block, double gap_mm) {
        m_y_mm += gap_mm;
        m_pages.back().push_back({block, {m_area.left(), m_y_mm, m_area.width(), block.height_mm}});
        m_y_mm += block.height_mm;
    }
    void growLast() {
        if (m_pages.back().empty()) return;
        Placed& last = m_pages.back().back();
        const double room_mm = m_area.bottom() - last.area.top();
        last.area.setHeight(std::max(last.area.height(), std::min(room_mm, last.block.growsTo_mm)));
    }

    QRectF m_area;
    double m_y_mm;
    std::vector<Placement> m_pages{1};
};

/// What must fit together: a block and, if it asks for that, what follows.
double neededHeight_mm(const std::vector<Block>& blocks, std::size_t i) {
    double needed_mm = blocks[i].height_mm;
    while (blocks[i].keepWithNext && i + 1 < blocks.size()) {
        ++i;
        needed_mm += blocks[i].before_mm + blocks[i].height_mm;
    }
    return needed_mm;
}

void drawPlacement(QPainter& painter, const Placement& placement) {
    for (const Placed& placed : placement) placed.block.draw(painter, placed.area);
}

}  // namespace

std::vector<Sheet> flow(const QString& title, std::vector<Block> blocks, const QRectF& area) {
    Filler filler(area);
    for (std::size_t i = 0; i < blocks.size(); ++i) filler.add(blocks[i], neededHeight_mm(blocks, i));
    std::vector<Sheet> sheets;
    for (Placement& placement : filler.finish()) {
        const QString name = sheets.empty() ? title : tr("%1, continued").arg(title);
        sheets.push_back(
            {name, [content = std::move(placement)](QPainter& painter) { drawPlacement(painter, content); }});
    }
    return sheets;
}

double stackedHeight_mm(const std::vector<Block>& blocks) {
    double height_mm = 0.0;
    for (const Block& block : blocks)
        height_mm += (&block == &blocks.front() ? 0.0 : block.before_mm) + block.height_mm;
    return height_mm;
}

void drawStacked(QPainter& painter, const std::vector<Block>& blocks, const QRectF& area) {
    double y_mm = area.top();
    for (const Block& block : blocks) {
        if (&block != &blocks.front()) y_mm += block.before_mm;
        block.draw(painter, {area.left(), y_mm, area.width(), block.height_mm});
        y_mm += block.height_mm;
    }
}

}  // namespace sagara::report
