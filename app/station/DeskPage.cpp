#include "app/station/DeskPage.h"

#include <QFutureWatcher>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <QtConcurrent/QtConcurrentRun>

#include "app/station/BridgeLink.h"
#include "app/station/ConsoleDoor.h"
#include "app/station/RosterDoor.h"
#include "app/station/Station.h"
#include "ui/run/RunTexts.h"
#include "ui/trainer/TrainerDesk.h"
#include "ui/trainer/WallPanel.h"
#include "ui/widgets/PreparedExercise.h"

namespace sagara::station {
namespace {

constexpr const char* kLayout = "ui.desk-layout";
constexpr int kBreath_ms = 10;

}  // namespace

DeskPage::DeskPage(Station& station, std::unique_ptr<StationRun> run,
                   std::shared_ptr<const ui::PreparedChart> chart)
    : m_station(station),
      m_run(std::move(run)),
      m_chart(chart ? std::move(chart) : ui::prepareChart(m_run->world())),
      m_wall(std::make_unique<StationWall>(
          m_run->world(),
          [r = m_run.get(), clock = wall::FrameClock()]() mutable { return r->momentForWall(clock); })),
      m_goingBack(new QWidget(this)),
      m_goingBackTo(new QLabel(m_goingBack)) {
    setWindowTitle(QString::fromStdString(m_run->world()->scenarioName));
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_goingBack);
    auto* const wait = new QHBoxLayout(m_goingBack);
    auto* const cancel = new QPushButton(tr("Cancel"), m_goingBack);
    cancel->setObjectName(QStringLiteral("stay"));
    cancel->setToolTip(tr("Stay where the run stands now"));
    wait->addWidget(m_goingBackTo, 1);
    wait->addWidget(cancel);
    m_goingBack->hide();
    connect(cancel, &QPushButton::clicked, this, [this] {
        ++m_ways;
        showGoingBack(false);
    });
    makeDesk();
}

DeskPage::~DeskPage() {
    delete m_console;
    const std::string kept = m_desk->layoutKept().toBase64().toStdString();
    if (m_station.settings().get(kLayout) != kept) m_station.settings().put(kLayout, kept);
    delete m_desk;  // before the run it looks at
    m_wall.reset();
}

void DeskPage::makeDesk() {
    delete std::exchange(m_desk, nullptr);
    m_desk = new ui::TrainerDesk(*m_run, m_station.stageFor(m_run->world()), this, m_chart);
    if (const auto kept = m_station.settings().get(kLayout))
        m_desk->setLayoutKept(QByteArray::fromBase64(QByteArray::fromStdString(*kept)));
    m_desk->setMayGoBack(m_run->mayGoBack());
    m_desk->setColours(m_station.colours());
    std::vector<ui::ChartTrackPoint> sailed;
    for (const core::TrackSample& s : m_run->sailedBefore())
        if (s.tick % core::kTicksPerSecond == 0 && !s.ships.empty())
            sailed.push_back({core::timeOfTick(s.tick).seconds(), s.ships[0].motion.position()});
    m_desk->showSailed(std::move(sailed));
    m_desk->hide();
    // Building it and showing it take a moment each: the windows live on in between.
    QTimer::singleShot(kBreath_ms, m_desk, [this] {
        m_desk->addPanel(QStringLiteral("wall"), tr("Wall"), QStringLiteral("view-gallery-google"),
                         new ui::WallPanel(*m_wall, m_desk));
        layout()->addWidget(m_desk);
        m_desk->show();
    });
    connect(m_desk, &ui::TrainerDesk::endWanted, this, [this] {
        if (QMessageBox::question(this, tr("Sagara"), tr("End the exercise? It is graded as it stands.")) ==
            QMessageBox::Yes)
            endRun();
    });
    // Queued: the desk that asks is replaced.
    connect(m_desk, &ui::TrainerDesk::goBackWanted, this, &DeskPage::goBack, Qt::QueuedConnection);
    connect(m_desk, &ui::TrainerDesk::consoleWanted, this, &DeskPage::openConsole);
}

void DeskPage::setColours(ui::PaletteName name) {
    if (m_desk != nullptr) m_desk->setColours(name);
}

void DeskPage::showEvent(QShowEvent* event) {
    ui::Page::showEvent(event);
    m_station.stageFor(m_run->world());  // another page may have shown another world
}

/// The desk waits, the windows do not.
void DeskPage::goBack(std::int64_t second) {
    const auto refuse = [this](const std::string& why) {
        QMessageBox::warning(this, tr("Sagara"), QString::fromStdString(why));
    };
    auto way = m_run->wayBack(second);
    if (!way) return refuse(way.error());
    using Found = core::Result<run::SetBack, std::string>;
    m_goingBackTo->setText(tr("Going back to %1 ...").arg(ui::elapsed({1'000'000 * second})));
    showGoingBack(true);
    auto* const watcher = new QFutureWatcher<std::shared_ptr<Found>>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, refuse, asked = ++m_ways] {
        watcher->deleteLater();
        if (asked != m_ways) return;  // called off
        const std::shared_ptr<Found> found = watcher->result();
        const auto trouble = *found ? m_run->goBack(std::move(*found).value()) : found->error();
        showGoingBack(false);
        if (trouble) return refuse(*trouble);
        delete m_console;
        makeDesk();
    });
    watcher->setFuture(
        QtConcurrent::run([way = std::move(way).value()] { return std::make_shared<Found>(way()); }));
}

void DeskPage::showGoingBack(bool on) {
    m_goingBack->setVisible(on);
    m_desk->setEnabled(!on);
}

void DeskPage::openConsole() {
    if (m_console) return m_console->activateWindow();
    ui::ConsoleOptions options;
    options.briefing = false;
    options.chart = m_chart;
    options.drawsStage = false;  // the desk does
    options.keys = false;        // BridgeLink takes them, as they are mapped
    m_console = consoleWindow(m_station, *m_run, options);
    new BridgeLink(m_station.input(), m_station.sound(), *m_console, *m_run);
}

bool DeskPage::mayLeave() {
    if (m_run->over()) return true;
    return QMessageBox::question(this, tr("Sagara"), tr("A run is on. End it and leave?")) ==
           QMessageBox::Yes;
}

void DeskPage::endRun() {
    ++m_ways;  // nothing goes back any more
    const run::RunSummary summary = m_run->end();
    m_station.replacePage(resultPage(m_station, m_run->recording(), summary));
}

}  // namespace sagara::station
