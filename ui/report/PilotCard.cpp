#include "ui/report/PilotCard.h"

#include <cmath>

#include "ui/report/Blocks.h"
#include "ui/report/PdfDocument.h"
#include "ui/report/Style.h"
#include "ui/report/Table.h"
#include "ui/report/TurningDrawing.h"

namespace sagara::report {
namespace {

constexpr double kApart_mm = 6.0;
constexpr double kHalf_mm = 0.5 * page::kTextWidth_mm - 3.0;
constexpr double kRightFrom_mm = 0.5 * page::kTextWidth_mm + 3.0;

QString shown(double value, int decimals) { return QString::number(value, 'f', decimals); }

std::vector<Block> facts(const QString& title, const std::vector<PilotCardData::Row>& rows, double label_mm) {
    std::vector<Block> blocks{sectionTitle(title)};
    Facts list;
    for (const auto& row : rows) list.emplace_back(fromStd(row.label), fromStd(row.value));
    for (Block& block : factBlocks(list, kHalf_mm, label_mm)) blocks.push_back(std::move(block));
    return blocks;
}

void add(std::vector<Block>& to, std::vector<Block> more) {
    for (Block& block : more) to.push_back(std::move(block));
}

std::vector<Block> telegraphTable(const PilotCardData& card) {
    Table table({{tr("Engine order"), 38.0},
                 {tr("Shaft, rpm"), 22.0, Qt::AlignRight},
                 {tr("Speed, kn"), 22.0, Qt::AlignRight}});
    for (const auto& step : card.telegraph)
        table.addRow({{fromStd(step.order)}, {shown(step.shaft_rpm, 0)}, {shown(step.speed_kn, 1)}});
    std::vector<Block> blocks{sectionTitle(tr("Engine and telegraph"))};
    add(blocks, table.takeBlocks());
    return blocks;
}

std::vector<Sheet> cardSheets(const PilotCardData& card) {
    std::vector<Block> left, right, all;
    add(left, facts(tr("Ship's particulars"), card.particulars, 42.0));
    add(left, facts(tr("Anchors"), card.anchors, 42.0));
    add(right, facts(tr("Steering"), card.steering, 50.0));
    add(right, facts(tr("Propulsion"), card.propulsion, 50.0));
    all.push_back(paragraph(fromStd(card.ship), {15.0, colour::kInk, true}, page::kTextWidth_mm, 0.0, 2));
    all.push_back(paragraph(tr("%1 · card of %2 · for training on the simulator, not for navigation")
                                .arg(fromStd(card.type), fromStd(card.date)),
                            {9.0, colour::kQuiet}, page::kTextWidth_mm, 1.0));
    all.push_back(sideBySide(std::move(left), std::move(right), kRightFrom_mm));
    all.back().before_mm = kApart_mm;
    all.push_back(
        sideBySide(telegraphTable(card),
                   facts(tr("Turning, full ahead, rudder hard over"), card.conditions.front().turning, 50.0),
                   kRightFrom_mm));
    all.back().before_mm = kApart_mm;
    Table table({{tr("Standard of MSC.137(76)"), 88.0},
                 {tr("Ship"), 26.0, Qt::AlignRight},
                 {tr("Limit"), 26.0, Qt::AlignRight},
                 {tr("Result"), 30.0, Qt::AlignRight}});
    for (const auto& check : card.checks)
        table.addRow({{fromStd(check.criterion)},
                      {fromStd(check.value)},
                      {fromStd(check.limit)},
                      {check.met ? tr("met") : tr("NOT met"),
                       {},
                       !check.met,
                       check.met ? colour::kPassed : colour::kFailed}});
    all.push_back(sectionTitle(tr("Manoeuvrability, deep calm water")));
    add(all, table.takeBlocks());
    return flow(tr("Pilot card"), std::move(all), page::kContent);
}

/// Turning circles and stopping in one condition: a page of the poster.
std::vector<Block> conditionBlocks(const PilotCardData& card, const PilotCardData::Condition& condition) {
    std::vector<Block> all;
    all.push_back(paragraph(fromStd(card.ship), {15.0, colour::kInk, true}, page::kTextWidth_mm, 0.0, 2));
    all.push_back(paragraph(
        tr("%1 · turning circles from %2 kn, rudder hard over, calm water. Dots: full minutes. %3")
            .arg(fromStd(condition.title), shown(condition.approach_kn, 1), fromStd(condition.note)),
        {9.0, colour::kQuiet}, page::kTextWidth_mm, 1.0));
    Block drawing;
    drawing.height_mm = 120.0;
    drawing.before_mm = 3.0;
    drawing.draw = [&condition, length_m = card.length_m](QPainter& painter, const QRectF& area) {
        drawTurningCircles(painter, area, condition, length_m);
    };
    all.push_back(std::move(drawing));
    Table table({{tr("Full astern from"), 29.0},
                 {tr("kn"), 10.0, Qt::AlignRight},
                 {tr("min:s"), 13.0, Qt::AlignRight},
                 {tr("Ahead, m"), 16.0, Qt::AlignRight},
                 {tr("Aside, m"), kHalf_mm - 68.0, Qt::AlignRight}});
    const auto aside = [](double side_m) {
        if (std::abs(side_m) < 0.5) return QStringLiteral("0");
        return (side_m > 0.0 ? tr("stbd %1") : tr("port %1")).arg(shown(std::abs(side_m), 0));
    };
    for (const auto& stop : condition.stops) {
        const int seconds = static_cast<int>(stop.time_s + 0.5);
        table.addRow({{fromStd(stop.from)},
                      {shown(stop.speed_kn, 1)},
                      {QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'))},
                      {shown(stop.reach_m, 0)},
                      {aside(stop.side_m)}});
    }
    std::vector<Block> stopping{sectionTitle(tr("Stopping"))};
    add(stopping, table.takeBlocks());
    all.push_back(
        sideBySide(std::move(stopping), facts(tr("Turning"), condition.turning, 50.0), kRightFrom_mm));
    return all;
}

std::vector<Sheet> posterSheets(const PilotCardData& card) {
    std::vector<Sheet> sheets;
    for (const auto& condition : card.conditions) {
        std::vector<Block> all = conditionBlocks(card, condition);
        if (&condition == &card.conditions.back()) {
            Table sources(
                {{tr("Group"), 26.0}, {tr("Quality"), 22.0}, {tr("Source"), page::kTextWidth_mm - 48.0}});
            for (const auto& source : card.sources)
                sources.addRow(
                    {{fromStd(source.group)}, {fromStd(source.quality)}, {fromStd(source.source)}});
            all.push_back(sectionTitle(tr("Where the numbers come from")));
            add(all, sources.takeBlocks());
        }
        for (Sheet& sheet : flow(tr("Wheelhouse poster"), std::move(all), page::kContent))
            sheets.push_back(std::move(sheet));
    }
    return sheets;
}

}  // namespace

void writePilotCard(const PilotCardData& card, const std::string& path) {
    std::vector<Sheet> sheets = cardSheets(card);
    for (Sheet& sheet : posterSheets(card)) sheets.push_back(std::move(sheet));
    const auto footer = [&](QPainter& painter, std::size_t number, std::size_t count) {
        drawPlainFooter(painter, fromStd(card.ship),
                        tr("after IMO resolution A.601(15); measured on the simulator's model"), number,
                        count);
    };
    writePdf(sheets, fromStd(card.ship) + QStringLiteral(" · ") + tr("Pilot card"), footer, path);
}

}  // namespace sagara::report
