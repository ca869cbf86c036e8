#include "ui/report/PilotCard.h"

#include <QBuffer>
#include <QFile>
#include <QGuiApplication>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <cassert>
#include <stdexcept>

#include "ui/report/Blocks.h"
#include "ui/report/PageFrame.h"
#include "ui/report/Style.h"
#include "ui/report/Table.h"
#include "ui/report/TurningDrawing.h"

namespace sagara::report {
namespace {

constexpr int kDotsPerMillimetre = 100;
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
    add(right, facts(tr("Steering"), card.steering, 42.0));
    add(right, facts(tr("Propulsion"), card.propulsion, 42.0));
    all.push_back(paragraph(fromStd(card.ship), {15.0, colour::kInk, true}, page::kTextWidth_mm, 0.0, 2));
    all.push_back(paragraph(tr("%1 · card of %2 · for training on the simulator, not for navigation")
                                .arg(fromStd(card.type), fromStd(card.date)),
                            {9.0, colour::kQuiet}, page::kTextWidth_mm, 1.0));
    all.push_back(sideBySide(std::move(left), std::move(right), kRightFrom_mm));
    all.push_back(sideBySide(telegraphTable(card),
                             facts(tr("Turning, full ahead, rudder hard over"), card.turning, 50.0),
                             kRightFrom_mm));
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

std::vector<Sheet> posterSheets(const PilotCardData& card) {
    std::vector<Block> all;
    all.push_back(paragraph(fromStd(card.ship), {15.0, colour::kInk, true}, page::kTextWidth_mm, 0.0, 2));
    all.push_back(
        paragraph(tr("Turning circles from %1 kn, rudder hard over, deep calm water. Dots: full minutes.")
                      .arg(shown(card.approach_kn, 1)),
                  {9.0, colour::kQuiet}, page::kTextWidth_mm, 1.0));
    Block drawing;
    drawing.height_mm = 120.0;
    drawing.before_mm = 3.0;
    drawing.draw = [&card](QPainter& painter, const QRectF& area) {
        drawTurningCircles(painter, area, card);
    };
    all.push_back(std::move(drawing));
    Table table({{tr("Full astern from"), 60.0},
                 {tr("Speed, kn"), 30.0, Qt::AlignRight},
                 {tr("Time, min:s"), 36.0, Qt::AlignRight},
                 {tr("Head reach, m"), 44.0, Qt::AlignRight}});
    for (const auto& stop : card.stops) {
        const int seconds = static_cast<int>(stop.time_s + 0.5);
        table.addRow({{fromStd(stop.from)},
                      {shown(stop.speed_kn, 1)},
                      {QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'))},
                      {shown(stop.reach_m, 0)}});
    }
    all.push_back(sectionTitle(tr("Stopping")));
    add(all, table.takeBlocks());
    Table sources({{tr("Group"), 26.0}, {tr("Quality"), 22.0}, {tr("Source"), page::kTextWidth_mm - 48.0}});
    for (const auto& source : card.sources)
        sources.addRow({{fromStd(source.group)}, {fromStd(source.quality)}, {fromStd(source.source)}});
    all.push_back(sectionTitle(tr("Where the numbers come from")));
    add(all, sources.takeBlocks());
    return flow(tr("Wheelhouse poster"), std::move(all), page::kContent);
}

void drawCardFooter(QPainter& painter, const PilotCardData& card, std::size_t number, std::size_t count) {
    const TextStyle style{7.5, colour::kQuiet};
    const double line_mm = page::kBottom_mm + 3.0;
    painter.setPen(linePen(colour::kRule, 0.15));
    painter.drawLine(QPointF(page::kLeft_mm, line_mm), QPointF(page::kRight_mm, line_mm));
    drawText(painter, {page::kLeft_mm, line_mm + 3.6}, Qt::AlignLeft,
             elided(fromStd(card.ship), style, page::kTextWidth_mm - 50.0), style);
    drawText(painter, {page::kLeft_mm, line_mm + 7.2}, Qt::AlignLeft,
             tr("after IMO resolution A.601(15); measured on the simulator's model"), style);
    drawText(painter, {page::kRight_mm, line_mm + 3.6}, Qt::AlignRight,
             tr("page %1 of %2").arg(number).arg(count), style);
}

QByteArray pdfOf(const PilotCardData& card) {
    std::vector<Sheet> sheets = cardSheets(card);
    for (Sheet& sheet : posterSheets(card)) sheets.push_back(std::move(sheet));
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter pdf(&buffer);
    pdf.setResolution(static_cast<int>(25.4 * kDotsPerMillimetre));
    pdf.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF()));
    pdf.setTitle(fromStd(card.ship) + QStringLiteral(" · ") + tr("Pilot card"));
    pdf.setCreator(QStringLiteral("Sagara"));
    QPainter painter(&pdf);
    painter.scale(kDotsPerMillimetre, kDotsPerMillimetre);
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        if (i > 0) pdf.newPage();
        drawHeader(painter, sheets[i].title);
        sheets[i].draw(painter);
        drawCardFooter(painter, card, i + 1, sheets.size());
    }
    painter.end();
    return buffer.data();
}

}  // namespace

void writePilotCard(const PilotCardData& card, const std::string& path) {
    assert(qGuiApp);  // fonts need it
    const QByteArray content = pdfOf(card);
    QSaveFile file(QFile::decodeName(QByteArray::fromStdString(path)));
    file.setDirectWriteFallback(true);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.commit()) {
        throw std::runtime_error("cannot write the pilot card to " + path + ": " +
                                 file.errorString().toStdString());
    }
}

}  // namespace sagara::report
