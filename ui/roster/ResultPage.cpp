#include "ui/roster/ResultPage.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/roster/AssessorForm.h"
#include "ui/roster/Field.h"
#include "ui/roster/RosterTexts.h"
#include "ui/roster/Rows.h"
#include "ui/theme/ThemeColours.h"

namespace sagara::ui::roster {
namespace {

constexpr int kAssessor_px = 380;

/// As many digits as their size deserves, and more where value and limit would read alike.
int digitsOf(double value, double limit) {
    const double size = std::max(std::abs(value), std::abs(limit));
    int digits = size >= 100.0 ? 0 : size >= 10.0 ? 1 : 2;
    while (digits < 3 && QString::number(value, 'f', digits) == QString::number(limit, 'f', digits)) ++digits;
    return digits;
}

QString valueText(double value, int digits, const QString& unit) {
    const QString number = QString::number(value, 'f', digits);
    return unit.isEmpty() ? number : number + QLatin1Char(' ') + unit;
}

Cell ordered(const QString& text, double order, Tone tone = Tone::Plain) {
    Cell cell(text, tone);
    cell.order = order;
    return cell;
}

Row rowOf(std::int64_t number, const Result::Task& t) {
    return {number,
            {t.title, t.done ? ordered(duration(t.time_s), t.time_s)
                             : ordered(ResultPage::tr("not done"), 1e12, Tone::Bad)}};
}

Row rowOf(std::int64_t number, const Result::Loss& l) {
    const int digits = digitsOf(l.value, l.limit);
    return {
        number,
        {ordered(duration(l.time_s), l.time_s), l.title, ordered(valueText(l.value, digits, l.unit), l.value),
         ordered(valueText(l.limit, digits, l.unit), l.limit),
         l.fails ? ordered(ResultPage::tr("fails the run"), 1e12, Tone::Bad)
                 : ordered(QStringLiteral("-%1").arg(scoreText(l.points)), l.points)}};
}

}  // namespace

ResultPage::ResultPage(std::unique_ptr<ResultPort> port, QWidget* parent)
    : Page(parent),
      m_port(std::move(port)),
      m_title(heading({}, 1.6, this)),
      m_facts(hint({}, this)),
      m_verdict(heading({}, 1.4, this)),
      m_score(heading({}, 2.4, this)),
      m_advice(new QLabel(this)),
      m_whyNot(new QLabel(this)),
      m_tasks(new RowsView(
          QStringLiteral("result-tasks"),
          {{tr("Task"), {}, false, true}, {tr("Done"), tr("Minutes:seconds after the start"), true}}, this)),
      m_losses(new RowsView(QStringLiteral("result-losses"),
                            {{tr("Time"), tr("Minutes:seconds after the start"), true},
                             {tr("Deduction"), {}, false, true},
                             {tr("Value"), tr("What was found"), true},
                             {tr("Limit"), {}, true},
                             {tr("Points"), tr("Of the score, which begins at 100"), true}},
                            this)),
      m_assessor(new AssessorForm(this)),
      m_trouble(new FieldNote(this)) {
    setObjectName(QStringLiteral("result-page"));
    m_verdict->setObjectName(QStringLiteral("result-verdict"));
    m_verdict->setAlignment(Qt::AlignCenter);
    m_score->setObjectName(QStringLiteral("result-score"));
    m_advice->setObjectName(QStringLiteral("result-advice"));
    m_advice->setTextFormat(Qt::PlainText);
    m_whyNot->setWordWrap(true);
    m_whyNot->setTextFormat(Qt::PlainText);
    m_title->setTextFormat(Qt::PlainText);
    m_losses->setEmptyText(tr("No points were deducted."));
    m_tasks->setEmptyText(tr("This mission has no tasks."));
    auto* const back = new QPushButton(tr("Back"), this);
    back->setObjectName(QStringLiteral("back"));
    back->setToolTip(tr("To the page before (Alt+Left)"));
    back->setShortcut(QKeySequence(Qt::ALT | Qt::Key_Left));
    auto* const debrief = new QPushButton(tr("Debrief..."), this);
    debrief->setObjectName(QStringLiteral("result-debrief"));
    debrief->setToolTip(tr("Plays the recording"));
    auto* const report = new QPushButton(tr("Report as PDF..."), this);
    report->setObjectName(QStringLiteral("result-report"));
    report->setToolTip(tr("Result, assessment, track chart and plots on paper"));

    auto* const top = new QHBoxLayout;
    top->addWidget(back);
    top->addSpacing(12);
    top->addWidget(m_title, 1);
    top->addWidget(debrief);
    top->addWidget(report);
    auto* const points = new QVBoxLayout;
    points->setSpacing(0);
    points->addWidget(m_score);
    points->addWidget(m_advice);
    auto* const band = new QHBoxLayout;
    band->setSpacing(20);
    band->addWidget(m_verdict);
    band->addLayout(points);
    band->addWidget(m_whyNot, 1);
    auto* const left = new QVBoxLayout;
    left->setSpacing(6);
    left->addLayout(band);
    left->addSpacing(8);
    left->addWidget(heading(tr("Tasks"), 1.1, this));
    left->addWidget(m_tasks, 2);
    left->addWidget(heading(tr("Deductions"), 1.1, this));
    left->addWidget(m_losses, 3);
    m_assessor->setFixedWidth(kAssessor_px);
    auto* const middle = new QHBoxLayout;
    middle->setSpacing(24);
    middle->addLayout(left, 1);
    middle->addWidget(m_assessor);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(20, 14, 20, 14);
    layout->addLayout(top);
    layout->addWidget(m_facts);
    layout->addWidget(m_trouble);
    layout->addSpacing(6);
    layout->addLayout(middle, 1);

    connect(back, &QPushButton::clicked, this, &Page::leaveWanted);
    connect(debrief, &QPushButton::clicked, this,
            [this] { m_trouble->say(m_port->openDebrief().value_or(QString())); });
    connect(report, &QPushButton::clicked, this, &ResultPage::report);
    connect(m_assessor, &AssessorForm::saveWanted, this, [this](const Entry& entry) {
        if (const Trouble trouble = m_port->save(entry)) return m_assessor->say(*trouble);
        refresh();
    });
    connect(m_assessor, &AssessorForm::signOffWanted, this, &ResultPage::signOff);
    refresh();
}

void ResultPage::setColours(PaletteName palette) {
    m_palette = palette;
    m_tasks->setColours(palette);
    m_losses->setColours(palette);
    showScore();
}

bool ResultPage::mayLeave() {
    if (!m_assessor->changed()) return true;
    return QMessageBox::question(this, tr("Result"), tr("The assessment is not saved. Leave it?")) ==
           QMessageBox::Yes;
}

void ResultPage::refresh() {
    m_result = m_port->result();
    setWindowTitle(tr("Result: %1").arg(m_result.mission));
    m_title->setText(m_result.mission);
    const QString who = m_result.person.isEmpty() ? tr("Nobody named") : m_result.person;
    m_facts->setText(tr("%1  ·  %2, level %3  ·  begun %4  ·  sailed %5%6")
                         .arg(who, typeName(m_result.type))
                         .arg(m_result.level)
                         .arg(dateTime(m_result.started), duration(m_result.duration_s),
                              m_result.type == QLatin1String("assess")
                                  ? tr("  ·  counts as a grade")
                                  : tr("  ·  practice, does not count as a grade")));
    std::vector<Row> tasks, losses;
    for (const auto& t : m_result.tasks) tasks.push_back(rowOf(std::int64_t(tasks.size()) + 1, t));
    for (const auto& l : m_result.losses) losses.push_back(rowOf(std::int64_t(losses.size()) + 1, l));
    m_tasks->show(std::move(tasks));
    m_losses->show(std::move(losses));
    m_assessor->show(m_result, m_port->assessors());
    showScore();
}

void ResultPage::showScore() {
    const Entry& e = m_result.entry;
    const std::optional<Score> valid =
        e.overrule ? std::optional(Score{e.score, e.passed}) : m_result.automatic;
    const ThemeColours& c = themeColours(m_palette);
    const bool passed = valid && valid->passed;
    m_verdict->setText(!valid ? tr("Not graded") : passed ? tr("PASSED") : tr("NOT PASSED"));
    const QColor behind = !valid ? c.section : passed ? c.running : c.alarm;
    const QColor ink = !valid ? c.text : passed ? c.onRunning : c.onAlarm;
    m_verdict->setStyleSheet(
        QStringLiteral("background: %1; color: %2; border-radius: 4px; padding: 12px 22px;")
            .arg(behind.name(), ink.name()));
    m_score->setText(valid ? tr("%1 of 100").arg(scoreText(valid->points)) : QString());
    QString advice = m_result.automatic ? tr("automatic score, advisory") : QString();
    if (e.overrule)
        advice = m_result.automatic
                     ? tr("assessor's score; automatic: %1, %2 (advisory)")
                           .arg(scoreText(m_result.automatic->points), passedText(m_result.automatic->passed))
                     : tr("assessor's score");
    m_advice->setText(advice);
    m_whyNot->setText(e.overrule ? tr("Overruled: %1").arg(e.reason) : passed ? QString() : m_result.whyNot);
}

void ResultPage::signOff(const Entry& entry, std::int64_t by) {
    auto* const box = new QMessageBox(
        QMessageBox::Question, tr("Sign off"),
        tr("Sign this assessment off? Comment, result and grade cannot be changed afterwards."),
        QMessageBox::Cancel, this);
    box->setObjectName(QStringLiteral("sign-box"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    const QPushButton* const sure = box->addButton(tr("Sign off"), QMessageBox::AcceptRole);
    connect(box, &QMessageBox::buttonClicked, this, [this, entry, by, sure](QAbstractButton* pressed) {
        if (static_cast<const QObject*>(pressed) != sure) return;
        if (const Trouble trouble = m_port->signOff(entry, by)) return m_assessor->say(*trouble);
        refresh();
    });
    box->open();
}

void ResultPage::report() {
    if (m_assessor->changed())
        return m_trouble->say(tr("The assessment is not saved; save it first, so that the report has it."));
    m_trouble->say({});
    const QString name = m_result.person.isEmpty() ? m_result.mission : m_result.person;
    writeReport(this, tr("Report %1 %2.pdf").arg(name, dateOnly(m_result.started)),
                [this](const QString& file) -> Job {
                    auto job = m_port->reportJob(file);
                    if (job) return std::move(job).value();
                    return [trouble = job.error()](JobControl&) { return trouble; };
                });
}

}  // namespace sagara::ui::roster
