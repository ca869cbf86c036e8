#include "app/station/Station.h"

#include <QCloseEvent>
#include <QMessageBox>

#include "app/files/BuildScenario.h"
#include "db/DocumentRepository.h"
#include "ui/start/StartPage.h"
#include "ui/trainer/TrainerDesk.h"

namespace sagara::station {
namespace {

std::vector<ui::ScenarioEntry> scenariosOf(run::Store& store) {
    std::vector<ui::ScenarioEntry> entries;
    if (store.database() != nullptr) {
        for (const auto& e : db::DocumentRepository(*store.database(), db::DocumentTable::Scenario).inUse())
            entries.push_back({e.key, e.name});
        return entries;
    }
    for (const std::string& id : store.assets().ids(core::DocumentKind::Scenario))
        entries.push_back({id, id});
    return entries;
}

}  // namespace

Station::Station(run::Store& store, render::StageOptions stage)
    : m_store(store),
      m_stageOptions(std::move(stage)),
      m_start(new ui::StartPage(
          scenariosOf(store), [&store](const std::string& id) { return files::buildScenario(store, id); },
          this)) {
    setWindowTitle(tr("Sagara"));
    addWidget(m_start);
    if (!store.trouble().empty()) m_start->setTrouble(QString::fromStdString(store.trouble()));
    connect(m_start, &ui::StartPage::chosen, this, [this](const ui::StartChoice& choice) {
        RunRequest request;
        request.scenario = choice.scenario;
        request.level = choice.level;
        request.type = choice.type;
        request.trainee = choice.trainee;
        request.pilot = choice.pilot;
        if (const auto trouble = open(request)) m_start->setTrouble(QString::fromStdString(*trouble));
    });
}

Station::~Station() { delete m_desk; }  // before the run and the stage it looks at

std::optional<std::string> Station::open(const RunRequest& request) {
    if (m_run) return "a run is open already";
    auto opened = StationRun::open(m_store, request);
    if (!opened) return opened.error();
    m_run = std::move(opened).value();
    if (!m_stage) {
        auto stage = render::Stage::open(m_stageOptions);
        if (stage) m_stage = std::move(stage).value();
    }
    if (m_stage && m_stage->show(m_run->world())) m_stage.reset();
    m_desk = new ui::TrainerDesk(*m_run, m_stage.get(), this);
    connect(m_desk, &ui::TrainerDesk::endWanted, this, [this] {
        if (confirmed(tr("End the exercise? It is graded as it stands."))) endRun();
    });
    addWidget(m_desk);
    setCurrentWidget(m_desk);
    setWindowTitle(m_desk->windowTitle());
    return std::nullopt;
}

void Station::endRun() {
    if (!m_run) return;
    const QString result = resultText(m_run->end());
    const QString trouble = QString::fromStdString(m_run->trouble());
    setCurrentWidget(m_start);
    setWindowTitle(tr("Sagara"));
    delete std::exchange(m_desk, nullptr);
    m_run.reset();
    auto* const box = new QMessageBox(QMessageBox::NoIcon, tr("Result"), result, QMessageBox::Ok, this);
    box->setObjectName(QStringLiteral("result"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    if (!trouble.isEmpty()) box->setInformativeText(trouble);
    box->open();
}

QString Station::resultText(const run::RunSummary& s) const {
    QString text = tr("<h3>%1: %2</h3><p>Score %3 of 100 (automatic, advisory). Sailed %4.</p>")
                       .arg(QString::fromStdString(m_run->world()->scenarioName).toHtmlEscaped(),
                            s.passed ? tr("passed") : tr("not passed"))
                       .arg(s.score, 0, 'f', 0)
                       .arg(QString::fromStdString(run::clock(s.simTime_s)));
    if (!s.passed && !s.whyNot.empty())
        text += QStringLiteral("<p>%1</p>").arg(QString::fromStdString(s.whyNot).toHtmlEscaped());
    for (const auto& loss : s.losses)
        text += tr("<br>%1  %2: %3 points")
                    .arg(QString::fromStdString(run::clock(loss.time_s)),
                         QString::fromStdString(loss.title).toHtmlEscaped())
                    .arg(loss.points, 0, 'f', 0);
    return text + tr("<p>Recording: %1</p>")
                      .arg(QString::fromStdString(m_run->recording().string()).toHtmlEscaped());
}

bool Station::confirmed(const QString& question) {
    return QMessageBox::question(this, tr("Sagara"), question) == QMessageBox::Yes;
}

void Station::closeEvent(QCloseEvent* event) {
    if (m_run && !m_run->over() && !confirmed(tr("A run is on. End it and leave?"))) return event->ignore();
    event->accept();
}

}  // namespace sagara::station
