#include "ui/report/SummaryPage.h"

#include <algorithm>

#include "ui/report/Blocks.h"
#include "ui/report/Format.h"
#include "ui/report/ResultBand.h"
#include "ui/report/SignOff.h"
#include "ui/report/Table.h"

namespace sagara::report {
namespace {

constexpr double kTasks_mm = 76.0;         ///< width of the table of tasks
constexpr double kRubricFrom_mm = 83.0;    ///< where the rubric begins next to it
constexpr double kTallestPair_mm = 108.0;  ///< higher tables go below each other and break over pages
const TextStyle kLessonStyle{20.0, colour::kNavy, true};
const TextStyle kObjectiveStyle{9.5};
const TextStyle kCodeStyle{8.5, colour::kQuiet};

std::vector<Block> lessonBlocks(const RunReport& report) {
    const QString name =
        report.scenarioName.empty() ? tr("Lesson without a name") : fromStd(report.scenarioName);
    std::vector<Block> blocks{paragraph(name, kLessonStyle, page::kTextWidth_mm, 0.0, 3)};
    if (!report.objective.empty()) {
        blocks.push_back(paragraph(fromStd(report.objective), kObjectiveStyle, page::kTextWidth_mm, 1.0, 8));
    }
    if (!report.competenceCode.empty()) {
        const QString code = tr("Competence: %1").arg(fromStd(report.competenceCode));
        blocks.push_back(paragraph(code, kCodeStyle, page::kTextWidth_mm, 1.0, 3));
    }
    return blocks;
}

QString shipOf(const RunReport& report) {
    if (report.vesselName.empty() || report.vesselName == report.shipName) return fromStd(report.shipName);
    return report.shipName.empty()
               ? fromStd(report.vesselName)
               : fromStd(report.shipName) + QStringLiteral(", ") + fromStd(report.vesselName);
}

Facts whoAndWhen(const RunReport& report) {
    return {{tr("Trainee"), report.trainee.empty() ? tr("not named") : fromStd(report.trainee)},
            {tr("Ship"), shipOf(report)},
            {tr("Began, local"), localTime(report.start, report.utcOffset_min, report.timeZone)},
            {tr("Began, UTC"), utcTime(report.start)},
            {tr("Weather"), fromStd(report.weather)}};
}

Facts whatRun(const RunReport& report) {
    return {{tr("Run type"), fromStd(report.runType)},
            {tr("Difficulty"), tr("level %1 of 5").arg(report.level)},
            {tr("Duration"), tr("%1 (mm:ss)").arg(clockTime(report.duration_s))},
            {tr("Area"), fromStd(report.areaName)},
            {tr("Seed"), QString::number(report.seed)}};
}

Block factsPanel(const RunReport& report) {
    constexpr double kInset_mm = 2.6, kRight_mm = 119.0;
    Block inner = sideBySide(
        factBlocks(whoAndWhen(report), kRight_mm - 6.0, 23.0),
        factBlocks(whatRun(report), page::kTextWidth_mm - kRight_mm - 2.0 * kInset_mm, 19.0), kRight_mm);
    Block block;
    block.before_mm = 4.0;
    block.height_mm = inner.height_mm + 2.0 * kInset_mm - 0.8;
    block.draw = [inner](QPainter& painter, const QRectF& area) {
        painter.setPen(linePen(colour::kRule, 0.2));
        painter.drawLine(area.topLeft(), area.topRight());
        painter.drawLine(area.bottomLeft(), area.bottomRight());
        inner.draw(painter, area.adjusted(0.0, kInset_mm, 0.0, 0.0));
    };
    return block;
}

std::vector<Block> taskBlocks(const RunReport& report, double width_mm) {
    std::vector<Block> blocks{sectionTitle(tr("Tasks"))};
    if (report.tasks.empty()) {
        blocks.push_back(paragraph(tr("This lesson has no tasks."), TextStyle{9.0}, width_mm, 0.0));
        return blocks;
    }
    Table table({{tr("No."), 9.0}, {tr("Task"), width_mm - 31.0}, {tr("Done, mm:ss"), 22.0, Qt::AlignRight}});
    int number = 0;
    for (const TaskLine& task : report.tasks) {
        const Table::Cell time = task.done ? Table::Cell{clockTime(task.time_s)}
                                           : Table::Cell{tr("not done"), {}, true, colour::kFailed};
        table.addRow({{QString::number(++number)}, {fromStd(task.title)}, time});
    }
    std::vector<Block> rows = table.takeBlocks();
    blocks.insert(blocks.end(), rows.begin(), rows.end());
    return blocks;
}

std::vector<Block> rubricBlocks(const RunReport& report, double width_mm) {
    std::vector<Block> blocks{sectionTitle(tr("Rubric"))};
    if (report.criteria.empty()) {
        blocks.push_back(paragraph(tr("This lesson has no criteria."), TextStyle{9.0}, width_mm, 0.0));
        return blocks;
    }
    Table table({{tr("Criterion"), width_mm - 33.0},
                 {tr("Weight"), 15.0, Qt::AlignRight},
                 {tr("Points lost"), 18.0, Qt::AlignRight}});
    double lost = 0.0;
    for (const CriterionLine& line : report.criteria) {
        lost += line.lost;
        const bool cost = line.lost > 0.0;
        const Table::Cell points{shortNumber(line.lost, 1), {}, cost, cost ? colour::kFailed : colour::kInk};
        table.addRow({{fromStd(line.title), {}, cost}, {shortNumber(line.weight, 1)}, points});
    }
    table.addTotal({{tr("Points lost in all"), {}, true}, {}, {shortNumber(lost, 1), {}, true}});
    std::vector<Block> rows = table.takeBlocks();
    blocks.insert(blocks.end(), rows.begin(), rows.end());
    return blocks;
}

void append(std::vector<Block>& to, std::vector<Block> more) {
    to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// Tasks and rubric next to each other where they are short enough, else below each other.
void appendTables(std::vector<Block>& blocks, const RunReport& report) {
    Block pair = sideBySide(taskBlocks(report, kTasks_mm),
                            rubricBlocks(report, page::kTextWidth_mm - kRubricFrom_mm), kRubricFrom_mm);
    pair.before_mm = 6.0;
    if (pair.height_mm <= kTallestPair_mm) {
        blocks.push_back(std::move(pair));
        return;
    }
    append(blocks, taskBlocks(report, page::kTextWidth_mm));
    append(blocks, rubricBlocks(report, page::kTextWidth_mm));
}

}  // namespace

std::vector<Sheet> summarySheets(const RunReport& report) {
    std::vector<Block> blocks = lessonBlocks(report);
    blocks.push_back(factsPanel(report));
    blocks.push_back(resultBand(report));
    appendTables(blocks, report);
    append(blocks, signOff(report));
    return flow(tr("Report of a run"), std::move(blocks), page::kContent);
}

}  // namespace sagara::report
