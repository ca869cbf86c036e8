#pragma once

#include <QColor>
#include <QPainter>
#include <QPointF>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/world/Area.h"

namespace sagara::chart {

/// A light, buoy or beacon: where, and the colour it is drawn in. See chartMarkOf.
struct ChartMark {
    enum class Colour : std::uint8_t { Red, Green, Yellow, Black, White };
    std::string name;
    core::NorthEast position;
    Colour colour = Colour::Black;
    bool fictional = false;
    core::MarkKind kind = core::MarkKind::Beacon;  ///< its shape: black and white prints have no colours
};

/// What marks are painted with: by day, or on a dark screen.
struct MarkColours {
    QColor ink{0x1a, 0x1e, 0x24};    ///< outlines and black marks
    QColor paper{0xff, 0xff, 0xff};  ///< white parts, and the margin round a mark
    QColor red{0xc8, 0x1e, 0x1e};
    QColor green{0x12, 0x82, 0x3c};
    QColor yellow{0xf2, 0xc1, 0x1d};
};

/// A mark of an area with the colour the IALA region ("A" or "B") gives it.
ChartMark chartMarkOf(const core::Mark& mark, std::string_view ialaRegion);

/// The symbol, about `size` high, its position at `at`; lines are drawn in proportion. Shapes follow the
/// topmarks: can, cone, two cones, sphere, cross.
void drawMark(QPainter& painter, QPointF at, const ChartMark& mark, double size,
              const MarkColours& colours = {});

}  // namespace sagara::chart
