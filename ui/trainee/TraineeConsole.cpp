#include "ui/trainee/TraineeConsole.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "ui/run/RunTexts.h"
#include "ui/trainee/AlarmStrip.h"
#include "ui/trainee/Bearings.h"
#include "ui/trainee/Briefing.h"
#include "ui/trainee/ChartPage.h"
#include "ui/trainee/ControlRow.h"
#include "ui/trainee/InstrumentStrip.h"
#include "ui/trainee/RadarPage.h"
#include "ui/trainee/RunControls.h"
#include "ui/trainee/ShipReadings.h"
#include "ui/trainee/SoundingPage.h"
#include "ui/trainee/ViewPanel.h"
#include "ui/widgets/ChartWidget.h"

namespace sagara::ui {
namespace {

constexpr int kFrame_ms = 50, kBeat_ms = 200;
constexpr double kWidth_px = 1280.0, kHeight_px = 720.0;  ///< what sizes are given for
constexpr double kInstruments_px = 106.0, kControls_px = 188.0, kLetters_px = 12.0;
constexpr double kRudderStill_rad = 0.02 * core::kDegree_rad;

}  // namespace

TraineeConsole::TraineeConsole(ExerciseRun& run, render::Stage* stage, const ConsoleOptions& options,
                               QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_stage(stage),
      m_options(options),
      m_sounder(core::sounderOf(run.world()->ships[options.ship]->vessel)),
      m_pages(new QStackedWidget(this)),
      m_briefing(new console::Briefing(*run.world(), options.ship, this)),
      m_frames(new QTimer(this)),
      m_beat(new QTimer(this)) {
    const core::World& world = *run.world();
    setObjectName(QStringLiteral("console"));
    setMinimumSize(960, 600);  // its contents grow and shrink with it
    setWindowTitle(tr("%1 - bridge of %2")
                       .arg(QString::fromStdString(world.scenarioName),
                            QString::fromStdString(world.ships[options.ship]->name)));
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_pages);
    m_pages->addWidget(m_briefing);
    m_pages->addWidget(makeBridge(stage));
    connect(m_briefing, &console::Briefing::watchTaken, this, &TraineeConsole::takeWatch);
    if (!options.briefing) m_pages->setCurrentIndex(1);
    addKeys();
    setColours(options.colours);
    connect(m_frames, &QTimer::timeout, this, &TraineeConsole::drawFrame);
    connect(m_beat, &QTimer::timeout, this, &TraineeConsole::refresh);
    m_frames->start(kFrame_ms);
    m_beat->start(kBeat_ms);
    refresh();
}

TraineeConsole::~TraineeConsole() = default;

QWidget* TraineeConsole::makeHeader() {
    m_header = new QWidget(this);
    m_alarms = new console::AlarmStrip(m_header);
    m_state = new QLabel(m_header);
    m_state->setObjectName(QStringLiteral("console-state"));
    auto* const horn = new QPushButton(tr("Horn"), m_header);
    horn->setObjectName(QStringLiteral("horn"));
    horn->setToolTip(tr("Whistle, as long as it is held (H)"));
    auto* const brief = new QPushButton(tr("Briefing"), m_header);
    brief->setObjectName(QStringLiteral("show-briefing"));
    brief->setToolTip(tr("Objective, tasks and criteria again"));
    auto* const row = new QHBoxLayout(m_header);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_alarms, 1);
    row->addWidget(m_state);
    row->addWidget(horn);
    row->addWidget(brief);
    if (m_options.showRunControls) {
        m_runControls = new console::RunControls(m_run, m_header);
        row->addWidget(m_runControls);
        connect(m_runControls, &console::RunControls::endWanted, this, &TraineeConsole::endWanted);
    }
    connect(m_alarms, &console::AlarmStrip::sounding, this, &TraineeConsole::alarm);
    connect(horn, &QPushButton::pressed, this, [this] { soundHorn(true); });
    connect(horn, &QPushButton::released, this, [this] { soundHorn(false); });
    connect(brief, &QPushButton::clicked, this, &TraineeConsole::showBriefing);
    return m_header;
}

QWidget* TraineeConsole::makeBridge(render::Stage* stage) {
    const core::World& world = *m_run.world();
    auto* const bridge = new QWidget(this);
    m_instruments = new console::InstrumentStrip(world, m_options.ship, bridge);
    m_view = new console::ViewPanel(stage, m_options.ship, bridge);
    m_chart = new console::ChartPage(m_run, m_options, bridge);
    m_radar = new console::RadarPage(world, m_options.ship, bridge);
    m_sounding = new console::SoundingPage(world, m_options.ship, bridge);
    m_controls = new console::ControlRow(m_run, m_options.ship, bridge);
    m_tabs = new QTabWidget(bridge);
    m_tabs->setObjectName(QStringLiteral("console-tabs"));
    m_tabs->setDocumentMode(true);
    m_tabs->addTab(m_chart, tr("Chart"));
    m_tabs->addTab(m_radar, tr("Radar"));
    m_tabs->addTab(m_sounding, tr("Sonar and echo sounder"));
    m_middle = new QSplitter(Qt::Horizontal, bridge);
    m_middle->setChildrenCollapsible(false);
    m_middle->addWidget(m_view);
    m_middle->addWidget(m_tabs);
    m_middle->setStretchFactor(0, 1);
    m_middle->setStretchFactor(1, 1);
    m_middle->setSizes({1000, 1000});
    auto* const column = new QVBoxLayout(bridge);
    column->setContentsMargins(4, 4, 4, 4);
    column->setSpacing(4);
    column->addWidget(makeHeader());
    column->addWidget(m_instruments);
    column->addWidget(m_middle, 1);
    column->addWidget(m_controls);
    connect(m_view, &console::ViewPanel::bearingTaken, this, &TraineeConsole::takeBearing);
    connect(&m_controls->bearings(), &console::BearingList::changed, this,
            [this] { m_chart->setBearings(m_controls->bearings().bearings()); });
    connect(m_controls, &console::ControlRow::helmGiven, this, &TraineeConsole::helmGiven);
    connect(m_controls, &console::ControlRow::telegraphGiven, this, &TraineeConsole::telegraphGiven);
    connect(m_controls, &console::ControlRow::thrusterGiven, this, &TraineeConsole::thrusterGiven);
    return bridge;
}

void TraineeConsole::addKeys() {
    const auto add = [this](const QKeySequence& keys, auto&& work) {
        auto* const shortcut = new QShortcut(keys, this, nullptr, nullptr, Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, this, [this, work] {
            if (onWatch() && !m_run.over()) work();
        });
    };
    add(Qt::Key_F2, [this] { m_tabs->setCurrentIndex(0); });
    add(Qt::Key_F3, [this] { m_tabs->setCurrentIndex(1); });
    add(Qt::Key_F4, [this] { m_tabs->setCurrentIndex(2); });
    if (!m_options.keys) return;
    constexpr double kOne_rad = core::kDegree_rad, kFive_rad = 5.0 * core::kDegree_rad;
    add(Qt::Key_Left, [this] { m_controls->turnHelmBy(-kOne_rad); });
    add(Qt::Key_Right, [this] { m_controls->turnHelmBy(kOne_rad); });
    add(Qt::SHIFT | Qt::Key_Left, [this] { m_controls->turnHelmBy(-kFive_rad); });
    add(Qt::SHIFT | Qt::Key_Right, [this] { m_controls->turnHelmBy(kFive_rad); });
    add(Qt::Key_M, [this] { m_controls->midships(); });
    add(Qt::Key_PageUp, [this] { m_controls->moveTelegraphs(1); });
    add(Qt::Key_PageDown, [this] { m_controls->moveTelegraphs(-1); });
    add(Qt::Key_A, [this] { acknowledgeAlarms(); });
}

bool TraineeConsole::onWatch() const { return m_pages->currentIndex() == 1; }

void TraineeConsole::takeWatch() {
    m_briefing->setTaken();
    m_pages->setCurrentIndex(1);
    m_controls->setFocus();
    if (m_options.startsRun && m_run.latest()->tick == 0) m_run.start();
    refresh();
    Q_EMIT watchTaken();
}

void TraineeConsole::showBriefing() { m_pages->setCurrentIndex(0); }

void TraineeConsole::addPage(QWidget* page, const QString& title) { m_tabs->addTab(page, title); }

void TraineeConsole::setColours(PaletteName name) {
    m_alarms->setColours(name);
    m_instruments->setColours(name);
    m_chart->setColours(name);
    m_radar->setColours(name);
    m_sounding->setColours(name);
    m_controls->setColours(name);
}

void TraineeConsole::setHelm(double rudder_rad) {
    if (!m_run.over()) m_controls->setHelm(rudder_rad);
}

void TraineeConsole::setTelegraph(int shaft, core::TelegraphStep step) {
    if (!m_run.over()) m_controls->setTelegraph(shaft, step);
}

void TraineeConsole::setThruster(int thruster, double share) {
    if (!m_run.over()) m_controls->setThruster(thruster, share);
}

void TraineeConsole::setPitch(int shaft, double pitch) {
    if (!m_run.over()) m_controls->setPitch(shaft, pitch);
}

void TraineeConsole::setAzimuth(int shaft, double angle_rad) {
    if (!m_run.over()) m_controls->setAzimuth(shaft, angle_rad);
}

void TraineeConsole::shiftPitch(int shaft, int steps) {
    if (!m_run.over()) m_controls->shiftPitch(shaft, steps);
}

void TraineeConsole::shiftAzimuth(int shaft, int steps) {
    if (!m_run.over()) m_controls->shiftAzimuth(shaft, steps);
}

void TraineeConsole::soundHorn(bool on) { Q_EMIT horn(on); }

void TraineeConsole::acknowledgeAlarms() { m_alarms->acknowledge(); }

void TraineeConsole::look(double yaw_radps) { m_look_radps = yaw_radps; }

void TraineeConsole::drawFrame() {
    if (!isVisible() || !onWatch()) return;
    const ExerciseRun::Picture picture = m_run.toDraw();
    if (m_look_radps != 0.0) m_view->turn(0.001 * kFrame_ms * m_look_radps);
    if (m_view->hasView()) {
        render::Moment moment = render::momentOf(picture.snapshot);
        moment.time = picture.time;
        m_view->aim(*m_run.world(), moment);
        if (m_options.drawsStage && m_stage != nullptr) m_stage->drawSoon(std::move(moment));
    }
    if (m_radar->isVisible()) m_radar->advance(picture.time, picture.snapshot);
}

void TraineeConsole::refresh() {
    const auto now = m_run.latest();
    const console::ShipReadings readings =
        console::readingsOf(*m_run.world(), *now, m_options.ship, m_sounder);
    m_instruments->show(*now, readings, m_sounding->depthAlarm_m());
    m_controls->show(*now, readings);
    m_controls->setEnabled(!m_run.over());
    m_sounding->show(*now, readings);
    m_chart->show(*now);
    m_view->show(readings);
    updateAlarms(*now);
    showState();
    if (m_runControls != nullptr) m_runControls->refresh();
}

void TraineeConsole::updateAlarms(const core::Snapshot& now) {
    const core::OwnShipView& own = now.ships[m_options.ship];
    if (now.time() != m_lastRudderAt) {
        m_rudderMoves = std::abs(own.rudder_rad - m_lastRudder_rad) > kRudderStill_rad;
        m_lastRudder_rad = own.rudder_rad;
        m_lastRudderAt = now.time();
    }
    console::AlarmInputs in;
    in.time_s = now.time().seconds();
    in.underKeel_m = core::soundedDepth_m(m_run.world()->area, m_sounder, own.motion, now.tide_m);
    in.depthAlarm_m = m_sounding->depthAlarm_m();
    if (own.autopilot.mode == core::AutopilotMode::Heading)
        in.offCourse_rad = core::wrapPi(own.motion.heading_rad - own.autopilot.setHeading_rad);
    in.enginesStopped = own.enginesFailed;
    for (const core::ThrusterState& thruster : own.thrusters) in.thrustersStopped.push_back(thruster.failed);
    in.steeringPumpsStopped = own.pumpsFailed;
    in.rudderBehind_rad = m_rudderMoves ? 0.0 : own.rudderOrder_rad - own.rudder_rad;
    in.lineParted = std::any_of(own.lines.begin(), own.lines.end(), [](const core::LineState& line) {
        return line.status == core::LineStatus::Parted;
    });
    in.cableParted = std::any_of(own.anchors.begin(), own.anchors.end(), [](const core::AnchorState& anchor) {
        return anchor.status == core::AnchorStatus::CableParted;
    });
    in.aground = own.aground;
    m_alarms->update(in);
}

void TraineeConsole::showState() {
    QString text;
    if (m_run.over())
        text = tr("The exercise is over");
    else if (!m_run.running())
        text = m_run.latest()->tick > 0    ? tr("Frozen")
               : m_options.showRunControls ? tr("Ready to start")
                                           : tr("Waiting for the trainer to start");
    else if (m_run.rate() > 1.05)
        text = tr("%1 times as fast").arg(m_run.rate(), 0, 'f', 0);
    if (m_options.showRunControls && !m_run.trouble().empty()) text = QString::fromStdString(m_run.trouble());
    if (m_state->text() != text) m_state->setText(text);
    m_state->setVisible(!text.isEmpty());
}

void TraineeConsole::takeBearing(double grid_rad) {
    const auto now = m_run.latest();
    const core::OwnShip& own = *m_run.world()->ships[m_options.ship];
    const core::ShipMotion& m = now->ships[m_options.ship].motion;
    console::Bearing bearing;
    bearing.from = core::HeadingFrame(m.position(), m.heading_rad).point(own.vessel.bridgeEye);
    bearing.grid_rad = grid_rad;
    bearing.true_rad = core::wrapTwoPi(grid_rad - m_run.world()->area.frame.convergence_rad(bearing.from));
    bearing.relative_rad = core::wrapPi(grid_rad - m.heading_rad);
    bearing.time = now->time();
    m_controls->bearings().add(bearing, localTime(*m_run.world(), now->time()));
}

/// Everything grows with the window, letters less than the instruments.
void TraineeConsole::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const double times = std::clamp(std::min(width() / kWidth_px, height() / kHeight_px), 0.8, 4.0);
    const double unit = std::pow(times, 0.85);
    m_instruments->setFixedHeight(static_cast<int>(kInstruments_px * unit));
    m_controls->setFixedHeight(static_cast<int>(kControls_px * unit));
    m_controls->setUnit(unit);
    const auto letters =
        static_cast<int>(std::lround(kLetters_px * std::max(1.0, 1.0 + 0.6 * (times - 1.0))));
    if (letters == m_letters_px) return;
    m_letters_px = letters;
    setStyleSheet(
        QStringLiteral("* { font-size: %1px; }").arg(letters));  // a font is not handed down past the theme
    m_chart->chart().setLetterSize(letters);
}

void TraineeConsole::keyPressEvent(QKeyEvent* event) {
    if (m_options.keys && event->key() == Qt::Key_H && !event->isAutoRepeat()) return soundHorn(true);
    QWidget::keyPressEvent(event);
}

void TraineeConsole::keyReleaseEvent(QKeyEvent* event) {
    if (m_options.keys && event->key() == Qt::Key_H && !event->isAutoRepeat()) return soundHorn(false);
    QWidget::keyReleaseEvent(event);
}

}  // namespace sagara::ui
