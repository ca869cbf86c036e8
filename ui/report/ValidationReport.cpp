#include "ui/report/ValidationReport.h"

#include <algorithm>

#include "ui/report/Blocks.h"
#include "ui/report/PdfDocument.h"
#include "ui/report/Table.h"

namespace sagara::report {
namespace {

constexpr double kPlotHeight_mm = 78.0, kPlotInText_mm = 68.0;

void add(std::vector<Block>& to, std::vector<Block> more) {
    for (Block& block : more) to.push_back(std::move(block));
}

std::vector<Block> summary(const ValidationData& data) {
    const auto ok = std::count_if(data.rows.begin(), data.rows.end(), [](const auto& r) { return r.ok; });
    std::vector<Block> blocks;
    blocks.push_back(paragraph(tr("Sagara against published results"), {15.0, colour::kInk, true},
                               page::kTextWidth_mm, 0.0, 2));
    blocks.push_back(paragraph(tr("%1 of %2 within tolerance · %3 · %4")
                                   .arg(ok)
                                   .arg(data.rows.size())
                                   .arg(fromStd(data.date), fromStd(data.program)),
                               {9.0, colour::kQuiet}, page::kTextWidth_mm, 1.0));
    blocks.push_back(paragraph(tr("Verification: the program against the computed solution of the same "
                                  "equations. Validation: against "
                                  "a measurement. Trend: against a limit, where nothing was measured."),
                               {8.0, colour::kQuiet}, page::kTextWidth_mm, 1.5));
    for (const auto& row : data.rows)
        if (!row.ok)
            blocks.push_back(paragraph(tr("Short: %1, %2").arg(fromStd(row.title), fromStd(row.quantity)),
                                       {8.5, colour::kFailed, true}, page::kTextWidth_mm, 1.0));
    blocks.back().height_mm += 2.0;
    return blocks;
}

std::vector<Block> caseTable(const ValidationData& data) {
    Table table({{tr("Case"), 57.0},
                 {tr("Quantity"), 41.0},
                 {tr("Measured"), 17.0, Qt::AlignRight},
                 {tr("Reference"), 17.0, Qt::AlignRight},
                 {tr("Error"), 18.0, Qt::AlignRight},
                 {tr("Tolerance"), 15.0, Qt::AlignRight},
                 {tr("Result"), 11.0, Qt::AlignRight}});
    std::string before;
    for (const auto& row : data.rows) {
        const bool same = row.title == before;
        before = row.title;
        table.addRow(
            {{same ? QString() : fromStd(row.title), same ? QString() : fromStd(row.kind)},
             {fromStd(row.quantity)},
             {fromStd(row.measured)},
             {fromStd(row.reference)},
             {fromStd(row.error)},
             {fromStd(row.tolerance)},
             {row.ok ? tr("ok") : tr("short"), {}, !row.ok, row.ok ? colour::kPassed : colour::kFailed}});
    }
    return table.takeBlocks();
}

/// Two plots next to each other.
std::vector<Block> plotBlocks(const std::vector<XyPlot>& plots, double height_mm) {
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < plots.size(); i += 2) {
        Block block;
        block.height_mm = height_mm;
        block.before_mm = 4.0;
        block.draw = [&plots, i, height_mm](QPainter& painter, const QRectF& area) {
            const double half_mm = 0.5 * page::kTextWidth_mm - 2.0;
            drawXyPlot(painter, plots[i], {area.left(), area.top(), half_mm, height_mm});
            if (i + 1 < plots.size())
                drawXyPlot(painter, plots[i + 1],
                           {area.left() + half_mm + 4.0, area.top(), half_mm, height_mm});
        };
        blocks.push_back(std::move(block));
    }
    return blocks;
}

std::vector<Block> tableBlocks(const SectionTable& table) {
    double others_mm = 0.0;
    for (std::size_t i = 1; i < table.columns.size(); ++i) others_mm += table.columns[i].width_mm;
    std::vector<Table::Column> columns;
    for (const auto& column : table.columns)
        columns.push_back(columns.empty()
                              ? Table::Column{fromStd(column.title), page::kTextWidth_mm - others_mm}
                              : Table::Column{fromStd(column.title), column.width_mm, Qt::AlignRight});
    Table drawn(std::move(columns));
    for (const auto& row : table.rows) {
        std::vector<Table::Cell> cells;
        for (const auto& cell : row)
            cells.push_back({fromStd(cell.text), fromStd(cell.note), false,
                             cell.quiet ? colour::kOtherText : colour::kInk});
        drawn.addRow(cells);
    }
    std::vector<Block> blocks;
    blocks.push_back(sectionTitle(fromStd(table.title)));
    add(blocks, drawn.takeBlocks());
    if (!table.note.empty())
        blocks.push_back(paragraph(fromStd(table.note), {7.5, colour::kQuiet}, page::kTextWidth_mm, 1.5));
    return blocks;
}

std::vector<Block> sectionBlocks(const ValidationSection& section) {
    std::vector<Block> blocks;
    for (const ValidationSection::Part& part : section.parts) {
        blocks.push_back(
            paragraph(fromStd(part.title), {13.0, colour::kInk, true}, page::kTextWidth_mm, 10.0, 2));
        blocks.back().keepWithNext = true;
        for (const std::string& text : part.paragraphs) {
            blocks.push_back(paragraph(fromStd(text), {9.0}, page::kTextWidth_mm, 2.0, 40));
            blocks.back().keepWithNext = true;
        }
        for (const SectionTable& table : part.tables) add(blocks, tableBlocks(table));
        add(blocks, plotBlocks(part.plots, kPlotInText_mm));
    }
    return blocks;
}

std::vector<Block> sourceBlocks(const ValidationData& data) {
    Table table({{tr("Case"), 62.0}, {tr("Reference"), page::kTextWidth_mm - 62.0}});
    for (const auto& source : data.sources)
        table.addRow({{fromStd(source.title)}, {fromStd(source.source), fromStd(source.note)}});
    return table.takeBlocks();
}

}  // namespace

void writeValidationReport(const ValidationData& data, const std::string& path) {
    std::vector<Block> table = summary(data), plots = plotBlocks(data.plots, kPlotHeight_mm);
    add(table, caseTable(data));
    std::vector<Sheet> sheets = flow(tr("Validation"), std::move(table), page::kContent);
    if (!plots.empty())
        for (Sheet& sheet : flow(tr("Plots"), std::move(plots), page::kContent))
            sheets.push_back(std::move(sheet));
    for (const ValidationSection& section : data.sections)
        for (Sheet& sheet : flow(fromStd(section.title), sectionBlocks(section), page::kContent))
            sheets.push_back(std::move(sheet));
    for (Sheet& sheet : flow(tr("Sources"), sourceBlocks(data), page::kContent))
        sheets.push_back(std::move(sheet));
    const auto footer = [&](QPainter& painter, std::size_t number, std::size_t count) {
        drawPlainFooter(painter, tr("Sagara · validation"), fromStd(data.date), number, count);
    };
    writePdf(sheets, tr("Sagara validation report"), footer, path);
}

}  // namespace sagara::report
