#pragma once

#include <QColor>
#include <QPen>
#include <QRectF>

/// Colours, pens and the page of the report. Colours keep their order of grey when printed in black and
/// white, and nothing is told by colour alone.
namespace sagara::report {

namespace colour {
inline constexpr QColor kInk{0x1a, 0x1e, 0x24};
inline constexpr QColor kQuiet{0x56, 0x60, 0x6b};  ///< secondary text
inline constexpr QColor kRule{0xb9, 0xc1, 0xc9};   ///< hairlines between things
inline constexpr QColor kGrid{0xd3, 0xd9, 0xde};   ///< behind the lines of a plot
inline constexpr QColor kPanel{0xf1, 0xf4, 0xf6};  ///< background of boxes
inline constexpr QColor kPaper{0xff, 0xff, 0xff};
inline constexpr QColor kNavy{0x12, 0x37, 0x5a};
inline constexpr QColor kPassed{0x1d, 0x68, 0x3b};
inline constexpr QColor kFailed{0xa5, 0x16, 0x21};  ///< also every deduction
inline constexpr QColor kLand{0xf0, 0xe5, 0xc8};
inline constexpr QColor kShore{0x7d, 0x6b, 0x3c};
inline constexpr QColor kWater{0xf7, 0xfb, 0xfd};
inline constexpr QColor kContour{0x7f, 0xa7, 0xc4};
inline constexpr QColor kContourText{0x44, 0x74, 0x98};
inline constexpr QColor kRoute{0x1c, 0x4f, 0x9e};
inline constexpr QColor kCorridor{0x3a, 0x7b, 0xd5, 0x2e};
inline constexpr QColor kOther{0x8a, 0x8f, 0x95};
inline constexpr QColor kOtherText{0x66, 0x6c, 0x73};
inline constexpr QColor kHostile{0xc0, 0x1a, 0x8a};
inline constexpr QColor kHull{0xd9, 0xdd, 0xe2};  ///< inside of the ship's outlines
}  // namespace colour

/// Millimetres from the top left corner of an A4 sheet. The left margin leaves room for the holes of a
/// folder.
namespace page {
inline constexpr double kWidth_mm = 210.0;
inline constexpr double kHeight_mm = 297.0;
inline constexpr double kLeft_mm = 20.0;
inline constexpr double kRight_mm = 196.0;
inline constexpr double kTextWidth_mm = kRight_mm - kLeft_mm;
inline constexpr double kTop_mm = 21.0;      ///< below the header
inline constexpr double kBottom_mm = 279.0;  ///< above the footer
inline const QRectF kContent{kLeft_mm, kTop_mm, kTextWidth_mm, kBottom_mm - kTop_mm};
}  // namespace page

/// A line of a width in mm with square corners.
QPen linePen(const QColor& colour, double width_mm, Qt::PenStyle style = Qt::SolidLine);
/// Dashes and gaps in mm.
QPen dashedPen(const QColor& colour, double width_mm, double dash_mm, double gap_mm);

}  // namespace sagara::report
