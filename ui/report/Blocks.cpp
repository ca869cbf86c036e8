#include "ui/report/Blocks.h"

#include <algorithm>

namespace sagara::report {
namespace {

const TextStyle kSectionStyle{11.0, colour::kNavy, true};
const TextStyle kLabelStyle{8.0, colour::kQuiet};
const TextStyle kValueStyle{9.0};

Block factBlock(const QString& label, const QString& value, double width_mm, double label_mm) {
    const TextBlock words(value, kValueStyle, width_mm - label_mm, 4);
    Block block;
    block.height_mm = words.height_mm() + 0.8;
    block.draw = [label, words, label_mm](QPainter& painter, const QRectF& area) {
        words.draw(painter, area.topLeft() + QPointF(label_mm, 0.0));
        const double middle_mm =
            area.top() + 0.5 * lineHeight_mm(kValueStyle) + 0.5 * capHeight_mm(kValueStyle);
        drawText(painter, {area.left(), middle_mm}, Qt::AlignLeft, elided(label, kLabelStyle, label_mm - 1.0),
                 kLabelStyle);
    };
    return block;
}

}  // namespace

Block sectionTitle(const QString& title) {
    Block block = paragraph(title, kSectionStyle, page::kTextWidth_mm, 6.0, 1);
    block.height_mm += 1.0;
    block.keepWithNext = true;
    return block;
}

Block paragraph(const QString& text, const TextStyle& style, double width_mm, double before_mm,
                int mostLines) {
    const TextBlock words(text, style, width_mm, mostLines);
    Block block;
    block.height_mm = words.height_mm();
    block.before_mm = before_mm;
    block.draw = [words](QPainter& painter, const QRectF& area) { words.draw(painter, area.topLeft()); };
    return block;
}

std::vector<Block> factBlocks(const Facts& facts, double width_mm, double label_mm) {
    std::vector<Block> blocks;
    for (const auto& [label, value] : facts) {
        if (!value.isEmpty()) blocks.push_back(factBlock(label, value, width_mm, label_mm));
    }
    return blocks;
}

Block sideBySide(std::vector<Block> left, std::vector<Block> right, double rightFrom_mm) {
    Block block;
    block.height_mm = std::max(stackedHeight_mm(left), stackedHeight_mm(right));
    block.draw = [left = std::move(left), right = std::move(right), rightFrom_mm](QPainter& painter,
                                                                                  const QRectF& area) {
        drawStacked(painter, left, area);
        drawStacked(painter, right, area.adjusted(rightFrom_mm, 0.0, 0.0, 0.0));
    };
    return block;
}

}  // namespace sagara::report
