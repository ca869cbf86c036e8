#include "ui/roster/HistoryPanel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/roster/Field.h"
#include "ui/roster/RosterTexts.h"
#include "ui/roster/Rows.h"

namespace sagara::ui::roster {
namespace {

constexpr int kPage_runs = 300;

QComboBox* box(const char* name, const QString& tip, QWidget* parent) {
    auto* const made = new QComboBox(parent);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    made->setMinimumContentsLength(14);
    return made;
}

QPushButton* button(const char* name, const QString& text, const QString& tip, QWidget* parent) {
    auto* const made = new QPushButton(text, parent);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    return made;
}

Cell scoreCell(const Run& run) {
    const std::optional<Score>& score = run.overruled ? run.overruled : run.automatic;
    if (!score) return QStringLiteral("-");
    Cell cell(scoreText(score->points));
    cell.order = score->points;
    return cell;
}

Cell whoseCell(const Run& run) {
    if (run.overruled) {
        Cell cell(HistoryPanel::tr("assessor's"));
        if (run.automatic)
            cell.tip = HistoryPanel::tr("Overrules the automatic %1, %2")
                           .arg(scoreText(run.automatic->points), passedText(run.automatic->passed));
        return cell;
    }
    return run.automatic ? Cell(HistoryPanel::tr("advisory"), Tone::Quiet) : Cell();
}

Cell passedCell(const Run& run) {
    const std::optional<Score>& score = run.overruled ? run.overruled : run.automatic;
    if (!score) return {};
    return {passedText(score->passed), score->passed ? Tone::Good : Tone::Bad};
}

Cell ordered(const QString& text, double order) {
    Cell cell(text);
    cell.order = order;
    return cell;
}

Row rowOf(const Run& r) {
    return {r.id,
            {ordered(dateTime(r.started), double(r.started.unix_s)),
             r.person.isEmpty() ? Cell(HistoryPanel::tr("nobody named"), Tone::Quiet) : Cell(r.person),
             r.className, r.mission, typeName(r.type), QString::number(r.level), scoreCell(r), whoseCell(r),
             passedCell(r), statusName(r.status), ordered(duration(r.duration_s), r.duration_s), r.signedBy}};
}

void refill(QComboBox& choice, const std::function<void()>& fill) {
    const QVariant before = choice.currentData();
    choice.clear();
    fill();
    choice.setCurrentIndex(std::max(0, choice.findData(before)));
}

}  // namespace

HistoryPanel::HistoryPanel(RosterPort& port, QWidget* parent)
    : QWidget(parent),
      m_port(port),
      m_most(kPage_runs),
      m_person(box("history-person", tr("Runs of one person"), this)),
      m_class(box("history-class", tr("Runs of those who are in a class now"), this)),
      m_mission(box("history-mission", tr("Runs of one mission"), this)),
      m_type(box("history-type", tr("Runs of one kind; only assessments count as grades"), this)),
      m_table(
          new RowsView(QStringLiteral("runs"),
                       {{tr("Begun"), tr("By this computer's clock")},
                        {tr("Person"), {}, false, true},
                        {tr("Class")},
                        {tr("Mission"), {}, false, true},
                        {tr("Run as"), tr("Only an assessment counts as a grade")},
                        {tr("Level"), tr("Difficulty, 1 to 5"), true},
                        {tr("Score"), tr("Of 100 points"), true},
                        {tr("Whose"), tr("Automatic scores are advisory")},
                        {tr("Result")},
                        {tr("Status")},
                        {tr("Duration"), tr("Minutes:seconds, or hours:minutes:seconds, simulated"), true},
                        {tr("Signed off by")}},
                       this)),
      m_summary(hint({}, this)),
      m_trouble(new FieldNote(this)),
      m_more(button("runs-more", tr("Show more"), tr("Older runs, too"), this)),
      m_result(button("run-result", tr("Result and sign-off..."),
                      tr("Tasks, deductions, the assessor's comment (Enter)"), this)),
      m_debrief(button("run-debrief", tr("Debrief..."), tr("Plays the recording"), this)),
      m_report(
          button("run-report", tr("Report as PDF..."), tr("Result, track chart and plots on paper"), this)),
      m_all(button("history-all", tr("All runs"), tr("Takes every filter away"), this)) {
    m_summary->setObjectName(QStringLiteral("history-summary"));
    m_result->setProperty("primary", true);
    auto* const filters = new QHBoxLayout;
    for (QComboBox* choice : {m_person, m_class, m_mission, m_type}) filters->addWidget(choice, 1);
    filters->addWidget(m_all);
    auto* const doing = new QHBoxLayout;
    doing->addWidget(m_summary, 1);
    for (QPushButton* b : {m_more, m_report, m_debrief, m_result}) doing->addWidget(b);
    auto* const layout = new QVBoxLayout(this);
    layout->addLayout(filters);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_trouble);
    layout->addLayout(doing);

    for (QComboBox* choice : {m_person, m_class, m_mission, m_type})
        connect(choice, &QComboBox::activated, this, [this] {
            m_most = kPage_runs;
            showRuns();
        });
    connect(m_all, &QPushButton::clicked, this, [this] {
        for (QComboBox* choice : {m_person, m_class, m_mission, m_type}) choice->setCurrentIndex(0);
        m_most = kPage_runs;
        showRuns();
    });
    connect(m_table, &RowsView::chosen, this, &HistoryPanel::showButtons);
    connect(m_table, &RowsView::opened, this, [this](std::int64_t id) { say(m_port.openResult(id)); });
    connect(m_more, &QPushButton::clicked, this, [this] {
        m_most += kPage_runs;
        showRuns();
    });
    connect(m_result, &QPushButton::clicked, this, [this] { say(m_port.openResult(m_table->selectedId())); });
    connect(m_debrief, &QPushButton::clicked, this,
            [this] { say(m_port.openDebrief(m_table->selectedId())); });
    connect(m_report, &QPushButton::clicked, this, &HistoryPanel::report);
}

void HistoryPanel::setColours(PaletteName palette) { m_table->setColours(palette); }

void HistoryPanel::refresh() {
    refill(*m_person, [this] {
        m_person->addItem(tr("Everybody"), qlonglong(0));
        for (const Person& p : m_port.people())
            m_person->addItem(p.retired ? tr("%1 (retired)").arg(p.name) : p.name, qlonglong(p.id));
    });
    refill(*m_class, [this] {
        m_class->addItem(tr("All classes"), qlonglong(0));
        for (const SchoolClass& c : m_port.classes()) m_class->addItem(c.name, qlonglong(c.id));
    });
    refill(*m_mission, [this] {
        m_mission->addItem(tr("All missions"), QString());
        for (const Mission& m : m_port.missions()) m_mission->addItem(m.name, m.key);
    });
    refill(*m_type, [this] {
        m_type->addItem(tr("All kinds of run"), QString());
        for (const char* type : {"assess", "train", "familiarise", "self-study", "demo"})
            m_type->addItem(typeName(QLatin1String(type)), QLatin1String(type));
    });
    showRuns();
}

void HistoryPanel::showRunsOf(std::int64_t person) {
    for (QComboBox* choice : {m_class, m_mission, m_type}) choice->setCurrentIndex(0);
    m_person->setCurrentIndex(std::max(0, m_person->findData(qlonglong(person))));
    m_most = kPage_runs;
    showRuns();
}

RunFilter HistoryPanel::filter() const {
    return {m_person->currentData().toLongLong(), m_class->currentData().toLongLong(),
            m_mission->currentData().toString(), m_type->currentData().toString()};
}

void HistoryPanel::showRuns() {
    m_trouble->say({});
    m_runs = m_port.runs(filter(), m_most);
    const int all = m_port.runCount(filter());
    const auto grades = std::count_if(m_runs.begin(), m_runs.end(), [](const Run& r) {
        return r.type == QLatin1String("assess") && r.automatic.has_value();
    });
    const bool filtered = m_person->currentIndex() > 0 || m_class->currentIndex() > 0 ||
                          m_mission->currentIndex() > 0 || m_type->currentIndex() > 0;
    m_table->setEmptyText(!m_port.trouble().isEmpty() ? tr("The runs cannot be read just now.")
                          : filtered
                              ? tr("No run fits. Choose something else above, or All runs.")
                              : tr("Nothing has been sailed yet. Go back and start a mission; every run "
                                   "is listed here when it begins."));
    std::vector<Row> rows;
    for (const Run& r : m_runs) rows.push_back(rowOf(r));
    m_table->show(std::move(rows));
    const auto shown = static_cast<int>(m_runs.size());
    QString words = shown < all ? tr("The newest %1 of %2 runs").arg(shown).arg(all)
                    : all == 1  ? tr("1 run")
                                : tr("%1 runs").arg(all);
    words += tr(": %1 graded, %2 for practice").arg(grades).arg(shown - int(grades));
    m_summary->setText(all == 0 ? QString() : words);
    m_more->setVisible(shown < all);
    showButtons();
}

void HistoryPanel::showButtons() {
    const bool one = m_table->selectedId() != 0;
    for (QPushButton* b : {m_result, m_debrief, m_report}) b->setEnabled(one);
}

void HistoryPanel::report() {
    const std::int64_t id = m_table->selectedId();
    const auto run = std::find_if(m_runs.begin(), m_runs.end(), [id](const Run& r) { return r.id == id; });
    if (run == m_runs.end()) return;
    const QString name = run->person.isEmpty() ? run->mission : run->person;
    writeReport(this, tr("Report %1 %2.pdf").arg(name, dateOnly(run->started)),
                [this, id](const QString& file) -> Job {
                    auto job = m_port.reportJob(id, file);
                    if (job) return std::move(job).value();
                    return [trouble = job.error()](JobControl&) { return trouble; };
                });
}

void HistoryPanel::say(const Trouble& trouble) { m_trouble->say(trouble.value_or(QString())); }

}  // namespace sagara::ui::roster
