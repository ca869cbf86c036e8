#include "ui/demo/DemoPage.h"

#include <QKeyEvent>
#include <QPainter>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "ui/chart/Format.h"
#include "ui/viewport/ViewportWidget.h"

namespace sagara::ui {
namespace {

constexpr int kFrame_ms = 33, kBeat_ms = 100;
/// Longer than this the machine slept: that is no reason to send a visitor away.
constexpr double kLongestBeat_s = 1.0;

const char* phaseName(DemoDirector::Phase phase) {
    switch (phase) {
        case DemoDirector::Phase::Attract:
            return "attract";
        case DemoDirector::Phase::Helm:
            return "helm";
        case DemoDirector::Phase::Score:
            return "score";
    }
    return "";
}

std::optional<DemoHelm::Key> helmKey(int key) {
    switch (key) {
        case Qt::Key_Left:
            return DemoHelm::Key::Port;
        case Qt::Key_Right:
            return DemoHelm::Key::Starboard;
        case Qt::Key_Home:
        case Qt::Key_Space:
            return DemoHelm::Key::Midships;
        case Qt::Key_PageUp:
        case Qt::Key_Up:
            return DemoHelm::Key::Faster;
        case Qt::Key_PageDown:
        case Qt::Key_Down:
            return DemoHelm::Key::Slower;
        default:
            return std::nullopt;
    }
}

bool isModifier(int key) {
    return key == Qt::Key_Control || key == Qt::Key_Shift || key == Qt::Key_Alt || key == Qt::Key_Meta ||
           key == Qt::Key_AltGr;
}

}  // namespace

DemoPage::DemoPage(DemoPorts ports, DemoSettings settings, QWidget* parent)
    : Page(parent),
      m_ports(std::move(ports)),
      m_settings(std::move(settings)),
      m_director(m_settings.timing),
      m_lock(m_settings.pin),
      m_log(m_settings.log, m_settings.logEvery_s),
      m_overlay(new DemoOverlay(this)),
      m_pad(new PinPad(m_lock, this)),
      m_frames(new QTimer(this)),
      m_beats(new QTimer(this)) {
    setObjectName(QStringLiteral("demo"));
    setWindowTitle(tr("Sagara - Exhibition"));
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    connect(m_overlay, &DemoOverlay::pressed, this, [this](int key) {
        touch();
        if (m_director.phase() == DemoDirector::Phase::Helm)
            give(m_helm.press(static_cast<DemoHelm::Key>(key)));
    });
    connect(m_pad, &PinPad::opened, this, &DemoPage::leave);
    connect(m_frames, &QTimer::timeout, this, &DemoPage::drawView);
    connect(m_beats, &QTimer::timeout, this,
            [this] { beat(std::min(kLongestBeat_s, 1e-3 * static_cast<double>(m_sinceBeat.restart()))); });
    begin(0);
}

DemoPage::~DemoPage() = default;

void DemoPage::begin(std::size_t lesson) {
    m_lesson = lesson;
    m_ports.exercises->begin(lesson);
    m_score = {};
    m_hints = {};
    m_eventsSeen = 0;
    m_camera = {DemoCameraKind::Chase};
    m_figures.lesson = static_cast<int>(lesson);
    checkFirstState();
    Q_EMIT atFirstState();
    if (!m_begun) return;
    showWorld();
    if (m_ports.wall) m_ports.wall->show();
    run().start();
}

/// Whatever visitors did, the lesson begins as it did the first time.
void DemoPage::checkFirstState() {
    const std::uint64_t hash = core::stateHash(run().state());
    const auto [it, isNew] = m_firstHashes.emplace(m_lesson, hash);
    if (!isNew && it->second != hash) ++m_figures.unequal;
}

void DemoPage::showWorld() {
    if (run().world() == m_world) return;
    m_world = run().world();
    DemoShown curtain;
    curtain.curtain = tr("Sagara\n%1").arg(QString::fromStdString(m_world->scenarioName));
    m_overlay->display(curtain);
    m_overlay->raise();
    repaint();  // setting up the scene takes a moment
    render::Stage* const stage = m_ports.stageFor ? m_ports.stageFor(m_world) : nullptr;
    if (stage != m_stage) {
        delete std::exchange(m_view, nullptr);
        m_stage = stage;
        if (stage != nullptr) {
            m_view =
                new ViewportWidget(stage->addViewport(std::max(16, width()), std::max(16, height())), this);
            m_view->setAttribute(Qt::WA_TransparentForMouseEvents);
            m_view->setFocusPolicy(Qt::NoFocus);
            m_view->setGeometry(rect());
            m_view->show();
            m_view->lower();
        }
    }
    caption();
}

void DemoPage::showEvent(QShowEvent*) {
    if (m_settings.fullScreen) window()->setWindowState(window()->windowState() | Qt::WindowFullScreen);
    if (!std::exchange(m_begun, true)) {
        showWorld();
        if (m_ports.wall) m_ports.wall->show();
        run().start();
    }
    m_sinceBeat.start();
    m_sinceFrame.start();
    m_frames->start(kFrame_ms);
    m_beats->start(kBeat_ms);
    QTimer::singleShot(0, this, [this] { setFocus(); });
}

void DemoPage::hideEvent(QHideEvent*) {
    m_frames->stop();
    m_beats->stop();
}

void DemoPage::resizeEvent(QResizeEvent*) {
    m_overlay->setGeometry(rect());
    if (m_view != nullptr) m_view->setGeometry(rect());
    m_pad->fit(size(), m_palette);
}

void DemoPage::setColours(PaletteName palette) {
    m_palette = palette;
    m_overlay->setColours(palette);
    m_pad->fit(size(), palette);
}

bool DemoPage::mayLeave() {
    if (!m_released && !m_lock.isOpen()) m_pad->open();
    return m_released;
}

void DemoPage::leave() {
    m_released = true;
    m_frames->stop();
    m_beats->stop();
    run().freeze();
    m_ports.wall.reset();
    if (m_settings.fullScreen) window()->setWindowState(window()->windowState() & ~Qt::WindowFullScreen);
    Q_EMIT leaveWanted();
}

void DemoPage::keyPressEvent(QKeyEvent* event) {
    if (isModifier(event->key())) return;
    if (m_settings.chord.matches(QKeySequence(event->keyCombination())) == QKeySequence::ExactMatch)
        return m_pad->open();
    if (event->isAutoRepeat() && m_director.phase() != DemoDirector::Phase::Helm) return;
    const bool steering = m_director.phase() == DemoDirector::Phase::Helm;
    touch();
    if (const auto key = helmKey(event->key()); key && steering) give(m_helm.press(*key));
}

void DemoPage::mousePressEvent(QMouseEvent*) {
    setFocus();
    touch();
}

void DemoPage::pollStick() {
    const auto now = m_ports.stick ? m_ports.stick() : std::nullopt;
    if (now && m_stick && stickMoved(*m_stick, *now)) {
        m_stick = now;
        touch();
    }
    if (!now || !m_stick) m_stick = now;  // plugged in or pulled out
    if (now && m_director.phase() == DemoDirector::Phase::Helm) give(m_helm.move(*now));
}

void DemoPage::touch() {
    if (const auto act = m_director.touched()) perform(*act);
}

void DemoPage::give(const DemoHelm::Orders& orders) {
    for (const core::Order& order : orders) run().give(0, order);
    if (!orders.empty()) caption();
}

void DemoPage::perform(DemoDirector::Act act) {
    switch (act) {
        case DemoDirector::Act::NextCamera:
            m_camera = nextDemoCamera(m_camera, *run().world(), render::momentOf(*run().latest()));
            break;
        case DemoDirector::Act::TakeHelm:
            takeHelm();
            break;
        case DemoDirector::Act::ShowScore:
            m_camera = {DemoCameraKind::Chase};
            break;
        case DemoDirector::Act::Reset:
            ++m_figures.resets;
            // The next lesson only after a whole one: another world takes the wall a while to load.
            begin(run().over() ? (m_lesson + 1) % m_ports.exercises->count() : m_lesson);
            break;
    }
    caption();
}

bool DemoPage::onPassage() const {
    const ExerciseRun& run = m_ports.exercises->run();
    const core::State state = run.state();
    if (state.ships.empty() || run.world()->pilot.empty()) return true;
    const auto& script = run.world()->pilot;
    const std::size_t step = state.ships[0].pilot.step;
    return step < script.size() && std::holds_alternative<core::TrackStep>(script[step]);
}

void DemoPage::takeHelm() {
    // Nobody learns to cast off or to anchor in three minutes: the visitor gets a ship under way.
    if (!onPassage()) begin(m_ports.exercises->helmLesson());
    const auto now = run().latest();
    if (now->ships.empty()) return;
    m_score = {};
    m_eventsSeen = run().eventsFrom(0).size();
    m_camera = {DemoCameraKind::Bridge};
    give(m_helm.take(*run().world()->ships[0], now->ships[0]));
}

void DemoPage::judge(double elapsed_s) {
    for (const core::Event& event : run().eventsFrom(m_eventsSeen)) {
        ++m_eventsSeen;
        m_score.happened(event);
    }
    if (m_director.phase() == DemoDirector::Phase::Helm) m_score.add(elapsed_s, *run().latest(), m_hints);
}

void DemoPage::beat(double elapsed_s) {
    m_figures.up_s += elapsed_s;
    m_figures.phase = phaseName(m_director.phase());
    if (m_log.noteIfDue(m_figures)) m_figures.longestStall_ms = 0.0;
    m_pad->advance(elapsed_s);
    pollStick();
    judge(elapsed_s);
    if (const auto act = m_director.advance(elapsed_s, run().over(), m_score.spoilt())) return perform(*act);
    caption();
}

void DemoPage::caption() {
    const core::World& world = *run().world();
    const core::State state = run().state();
    const auto now = run().latest();
    m_hints = hintsFor(world, *now, state.assessment.route);
    DemoShown shown;
    shown.lesson = QString::fromStdString(world.scenarioName);
    shown.camera = demoCamera(world, m_camera);
    shown.caption = demoCaption(world, state, *now, m_hints);
    shown.invites = m_director.phase() == DemoDirector::Phase::Attract;
    if (m_director.phase() == DemoDirector::Phase::Helm) {
        const QString next = m_hints.waypoint
                                 ? tr("Steer %1° to “%2”")
                                       .arg(chart::bearing(m_hints.waypoint->bearing_rad / core::kDegree_rad),
                                            QString::fromStdString(m_hints.waypoint->name))
                                 : tr("Steer where you like");
        shown.guide = {m_director.helmLeft_s(), demoRudder(m_helm.rudder_rad()), demoEngine(m_helm.step()),
                       next};
    }
    if (m_director.phase() == DemoDirector::Phase::Score) {
        shown.verdict = {
            m_score.stars(), demoVerdict(m_score.verdict()),
            tr("You sailed %1. Thank you for your visit!").arg(demoDistance(m_score.sailed_m()))};
    }
    m_overlay->display(std::move(shown));
}

void DemoPage::drawView() {
    const double since_ms = m_sinceFrame.isValid() ? static_cast<double>(m_sinceFrame.restart()) : 0.0;
    m_figures.longestStall_ms = std::max(m_figures.longestStall_ms, since_ms);
    if (m_stage == nullptr || m_view == nullptr) return;
    const ExerciseRun::Picture picture = run().toDraw();
    render::Moment moment = render::momentOf(picture.snapshot);
    moment.time = picture.time;
    m_view->refresh();
    aim(m_view->rig(), m_camera, *run().world(), moment);
    m_view->aim(*run().world(), moment);
    m_stage->drawSoon(std::move(moment));
    ++m_figures.frames;
}

void DemoPage::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (m_view != nullptr) return;
    painter.setPen(Qt::lightGray);
    painter.drawText(rect(), Qt::AlignCenter, tr("No picture: this machine has no OpenGL 3.3."));
}

}  // namespace sagara::ui
