#pragma once

#include <QString>
#include <utility>
#include <vector>

#include "ui/report/Flow.h"
#include "ui/report/Text.h"

/// Blocks that several pages use.
namespace sagara::report {

/// A title above what follows, kept on its page.
Block sectionTitle(const QString& title);
Block paragraph(const QString& text, const TextStyle& style, double width_mm, double before_mm,
                int mostLines = 12);

/// Labels and values in two aligned columns: "Trainee   Lt Perera".
using Facts = std::vector<std::pair<QString, QString>>;
std::vector<Block> factBlocks(const Facts& facts, double width_mm, double label_mm);

/// Two stacks of blocks next to each other as one block.
Block sideBySide(std::vector<Block> left, std::vector<Block> right, double rightFrom_mm);

}  // namespace sagara::report
