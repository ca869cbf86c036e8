#include "ui/report/DeductionPages.h"

#include "ui/report/Blocks.h"
#include "ui/report/Format.h"
#include "ui/report/Table.h"

namespace sagara::report {
namespace {

const TextStyle kPlainStyle{9.0};
const TextStyle kSourceStyle{8.0, colour::kQuiet};
constexpr int kPlaceDecimals = 3;  ///< of a minute: 2 m, as a GPS shows it

Table::Cell placeCell(const RunReport& report, core::NorthEast place) {
    const core::GeoPoint geo = report.frame.toGeo(place);
    return {
        latitude(geo.lat_deg, kPlaceDecimals) + QLatin1Char('\n') + longitude(geo.lon_deg, kPlaceDecimals),
        {}};
}

Table::Cell titleCell(const DeductionLine& line) {
    const QString quantity = fromStd(line.quantity);
    if (!line.failed) return {fromStd(line.title), quantity};
    const QString fails = tr("fails the run");
    return {fromStd(line.title), quantity.isEmpty() ? fails : quantity + QStringLiteral(" · ") + fails, true,
            colour::kFailed};
}

std::vector<Block> listBlocks(const RunReport& report) {
    Table table({{tr("No."), 10.0},
                 {tr("Time (mm:ss)"), 22.0},
                 {tr("Criterion and what was measured"), 60.0},
                 {tr("Value"), 21.0, Qt::AlignRight},
                 {tr("Limit"), 21.0, Qt::AlignRight},
                 {tr("Points"), 14.0, Qt::AlignRight},
                 {tr("Position"), 28.0, Qt::AlignRight}});
    int number = 0;
    double points = 0.0;
    for (const DeductionLine& line : report.deductions) {
        const ValueAndLimit shown = valueAndLimit(line);
        points += line.points;
        table.addRow({{QString::number(++number), {}, true, colour::kFailed},
                      {clockTime(line.time_s)},
                      titleCell(line),
                      {shown.value, {}, true},
                      {shown.limit},
                      {shortNumber(line.points, 1), {}, true},
                      placeCell(report, line.place)});
    }
    table.addTotal(
        {{}, {}, {tr("Points deducted in all"), {}, true}, {}, {}, {shortNumber(points, 1), {}, true}, {}});
    return table.takeBlocks();
}

Facts provenance(const RunReport& report) {
    return {{tr("Graded from"), fromStd(report.gradedFrom)},
            {tr("Build"), fromStd(report.buildId)},
            {tr("State hash"), fromStd(report.stateHash)},
            {tr("Seed"), QString::number(report.seed)},
            {tr("Depths"),
             report.depthDatum.empty() ? QString() : tr("metres below %1").arg(fromStd(report.depthDatum))},
            {tr("Chart"), fromStd(report.chartNotice)}};
}

void appendProvenance(std::vector<Block>& blocks, const RunReport& report) {
    blocks.push_back(sectionTitle(tr("Where this report comes from")));
    for (Block& block : factBlocks(provenance(report), page::kTextWidth_mm, 26.0))
        blocks.push_back(std::move(block));
    blocks.push_back(paragraph(
        tr("Sagara computed score and result from the limits of the lesson. They advise the assessor; "
           "they do not replace the assessor's judgement. Times are minutes and seconds since the "
           "start of the run; positions are WGS 84."),
        kPlainStyle, page::kTextWidth_mm, 2.5));
    if (report.attribution.empty()) return;
    blocks.push_back(sectionTitle(tr("Sources of the chart data")));
    for (const std::string& source : report.attribution) {
        blocks.push_back(paragraph(fromStd(source), kSourceStyle, page::kTextWidth_mm, 1.2));
    }
}

}  // namespace

std::vector<Sheet> deductionSheets(const RunReport& report) {
    std::vector<Block> blocks;
    if (report.deductions.empty()) {
        blocks.push_back(
            paragraph(tr("No points were deducted."), TextStyle{11.0}, page::kTextWidth_mm, 0.0));
    } else {
        blocks = listBlocks(report);
    }
    appendProvenance(blocks, report);
    return flow(tr("Deductions"), std::move(blocks), page::kContent);
}

}  // namespace sagara::report
