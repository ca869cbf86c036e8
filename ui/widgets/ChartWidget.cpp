#include "ui/widgets/ChartWidget.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <cmath>

#include "core/base/Shapes.h"
#include "ui/widgets/ChartTexts.h"
#include "ui/widgets/SceneLayers.h"
#include "ui/widgets/ToolLayer.h"

namespace sagara::ui {
namespace {

constexpr double kZoomStep = 1.25;
constexpr double kDragFrom_px = 4.0;  ///< a press that moves less is a click
constexpr double kReach_px = 10.0;
constexpr double kFitMargin_px = 12.0;
constexpr double kPanStep = 0.125;  ///< of the width, for the arrow keys

}  // namespace

ChartWidget::ChartWidget(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Chart"));
    m_look.pixel_mm = 25.4 / 96.0;
    m_look.chart = prepareChart(nullptr, 5.0);
    m_camera.setSize(chartArea().size());
    showCursor();
}

// what is shown

void ChartWidget::setChart(std::shared_ptr<const PreparedChart> chart) {
    if (!chart) chart = prepareChart(nullptr, 5.0);
    const bool another = chart->area != m_look.chart->area;
    m_look.chart = std::move(chart);
    if (another) fitArea();
    update();
}

void ChartWidget::setColours(PaletteName name) {
    m_look.palette = name;
    update();
}

void ChartWidget::setLayers(ChartLayers shown) {
    m_look.shown = shown;
    update();
}

void ChartWidget::setLayerShown(ChartLayer layer, bool shown) {
    m_look.shown.setFlag(layer, shown);
    update();
}

void ChartWidget::setLetterSize(double letter_px) {
    m_look.letter_px = letter_px;
    m_camera.setSize(chartArea().size());
    update();
}

void ChartWidget::setPixelPitch(double pixel_mm) {
    m_look.pixel_mm = pixel_mm;
    update();
}

void ChartWidget::setScene(ChartScene scene) {
    m_scene = std::move(scene);
    m_routeShape.step_m = 0.0;
    shipsChanged();
}

void ChartWidget::setOwnShips(std::vector<ChartShip> ships) {
    m_scene.ownShips = std::move(ships);
    shipsChanged();
}

void ChartWidget::setTargets(std::vector<ChartShip> ships) {
    m_scene.targets = std::move(ships);
    update();
}

void ChartWidget::setTracks(std::vector<ChartTrack> tracks) {
    m_scene.tracks = std::move(tracks);
    update();
}

void ChartWidget::extendTrack(std::size_t track, const ChartTrackPoint& point) {
    if (track >= m_scene.tracks.size()) m_scene.tracks.resize(track + 1);
    m_scene.tracks[track].points.push_back(point);
    update();
}

void ChartWidget::setPredictions(std::vector<ChartPrediction> predictions) {
    m_scene.predictions = std::move(predictions);
    update();
}

void ChartWidget::setRoute(const core::Route& route) {
    m_scene.route = route;
    m_routeShape.step_m = 0.0;
    m_scene.path = route.waypoints.size() > 1 ? core::RoutePath(route) : core::RoutePath();
    update();
}

void ChartWidget::setZones(std::vector<ChartZone> zones) {
    m_scene.zones = std::move(zones);
    update();
}

void ChartWidget::setAnchors(std::vector<ChartAnchor> anchors) {
    m_scene.anchors = std::move(anchors);
    update();
}

void ChartWidget::setForces(std::vector<ShownForce> forces, double NPerPx) {
    m_scene.forces = std::move(forces);
    m_scene.forceScale_NPerPx = NPerPx;
    update();
}

void ChartWidget::setHandles(std::vector<ChartHandle> handles) {
    const bool dragging = m_gesture == Gesture::Handle;
    if (dragging && m_handle < m_scene.handles.size() && m_handle < handles.size() &&
        handles[m_handle].id == m_scene.handles[m_handle].id) {
        handles[m_handle].position = m_scene.handles[m_handle].position;  // the hand has it
    } else if (dragging) {
        m_gesture = Gesture::None;
    }
    m_scene.handles = std::move(handles);
    update();
}

void ChartWidget::setClearance(double clearance_m) {
    m_scene.clearance_m = clearance_m;
    update();
}

void ChartWidget::setVectorLength(double minutes) {
    m_scene.vector_min = minutes;
    update();
}

void ChartWidget::shipsChanged() {
    std::optional<ChartCamera::Pose> pose;
    if (!m_scene.ownShips.empty()) {
        const ChartShip& ship = m_scene.ownShips.front();
        pose = {ship.position, ship.heading_rad};
        m_tools.ownShipAt(ship.position);
    }
    m_camera.setOwnShip(pose);
    update();
}

// where the view is

void ChartWidget::fitArea() {
    fitTo(m_look.chart->extent);
    m_whole = true;
}

void ChartWidget::fitTo(const chart::Extent& extent) {
    const bool followed = m_camera.following();
    m_camera.fit(extent, kFitMargin_px);
    afterMoving(followed);
}

void ChartWidget::centreOn(core::NorthEast p) {
    const bool followed = m_camera.following();
    m_camera.centreOn(p);
    afterMoving(followed);
}

void ChartWidget::zoomIn() {
    m_camera.zoom(view().middle(), kZoomStep);
    afterMoving(following());
}

void ChartWidget::zoomOut() {
    m_camera.zoom(view().middle(), 1.0 / kZoomStep);
    afterMoving(following());
}

void ChartWidget::follow(bool on) {
    const bool followed = m_camera.following();
    m_camera.follow(on);
    afterMoving(followed);
}

void ChartWidget::setHeadUp(bool on) {
    m_camera.setOrientation(on ? ChartCamera::Orientation::HeadUp : ChartCamera::Orientation::NorthUp);
    update();
}

void ChartWidget::afterMoving(bool followedBefore) {
    m_whole = false;
    update();
    if (m_camera.following() != followedBefore) Q_EMIT followingChanged(m_camera.following());
}

void ChartWidget::chooseTool(ChartTools::Tool tool) {
    if (m_tools.tool() == tool) return;
    m_tools.choose(tool);
    showCursor();
    update();
    Q_EMIT toolChanged(tool);
}

// what lies where

QRectF ChartWidget::chartArea() const {
    return {0.0, 0.0, 1.0 * width(), std::max(1.0, height() - readoutHeight_px(m_look.letter_px))};
}

QRectF ChartWidget::stripArea() const {
    const QRectF above = chartArea();
    return {0.0, above.bottom(), above.width(), height() - above.bottom()};
}

const core::LocalFrame& ChartWidget::frame() const {
    static const core::LocalFrame kNowhere{{}};
    return m_look.chart->area ? m_look.chart->area->frame : kNowhere;
}

std::optional<core::NorthEast> ChartWidget::ownShip() const {
    if (m_scene.ownShips.empty()) return {};
    return m_scene.ownShips.front().position;
}

ChartPick ChartWidget::pickAt(QPointF at) const {
    return pickOnChart(*m_look.chart, m_scene, m_look.shown, view(), at, kReach_px);
}

std::optional<std::size_t> ChartWidget::handleAt(QPointF at) const {
    std::optional<std::size_t> found;
    double nearest_px = kReach_px;
    for (std::size_t i = 0; i < m_scene.handles.size(); ++i) {
        const QPointF off = view().toScreen(m_scene.handles[i].position) - at;
        const double distance_px = std::hypot(off.x(), off.y());
        if (distance_px > nearest_px) continue;
        nearest_px = distance_px;
        found = i;
    }
    return found;
}

ChartReadout ChartWidget::readout() const {
    ChartReadout words;
    const core::Area* area = m_look.chart->area.get();
    words.notice = area ? QString::fromStdString(area->notice) : tr("Not for navigation.");
    if (!area) return words;
    words.source = depthNote(*area);
    if (m_cursor) {
        words.position = positionText(frame(), *m_cursor);
        words.depth = tr("depth: %1").arg(depthText(*m_look.chart, *m_cursor));
    } else if (ownShip()) {
        words.position = positionText(frame(), *ownShip());
        words.depth = tr("position of %1").arg(m_scene.ownShips.front().name);
    } else {
        words.position = QStringLiteral("–");
    }
    if (m_tools.range()) {
        words.measured = rangeBearingText(measure(frame(), m_tools.range()->from, m_tools.range()->to));
        words.measuredFrom = m_tools.range()->fromOwnShip ? tr("from own ship") : tr("range and bearing");
    } else if (m_tools.rule()) {
        words.measured = ruleText(*m_tools.rule(), frame(), ownShip());
        words.measuredFrom = tr("parallel rule; Shift turns it");
    } else if (m_cursor && ownShip()) {
        words.measured = rangeBearingText(measure(frame(), *ownShip(), *m_cursor));
        words.measuredFrom = tr("cursor from own ship");
    }
    return words;
}

QString ChartWidget::tipAt(QPointF at) const {
    const core::Area* area = m_look.chart->area.get();
    if (!chartArea().contains(at)) {
        if (!area) return {};
        QStringList lines{QString::fromStdString(area->notice), depthNote(*area)};
        for (const std::string& credit : area->attribution) lines << QString::fromStdString(credit);
        return lines.join(u'\n');
    }
    if (const auto handle = handleAt(at)) return m_scene.handles[*handle].hint;
    return pickAt(at).text;
}

// events

void ChartWidget::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    m_look.devicePixelRatio = devicePixelRatioF();
    const QRectF area = chartArea();
    painter.setClipRect(area);
    m_picture.show(m_look, view());
    m_picture.draw(painter, view());
    ChartCanvas canvas(painter, view(), chartPalette(m_look.palette), m_look.shown, m_look.letter_px,
                       m_look.pixel_mm);
    const bool any = m_look.chart->area != nullptr;
    for (const QRectF& name : m_picture.names(view())) canvas.labels.block(name);
    canvas.labels.block(scaleBox(canvas));
    if (any && canvas.shows(ChartLayer::Graticule)) drawGraticuleTexts(canvas, frame());
    const double step_m = routeStep_m(view());
    if (m_routeShape.step_m != step_m) m_routeShape = routeShape(m_scene.route, m_scene.path, step_m);
    drawScene(canvas, m_scene, m_routeShape, frame());
    if (any) drawScaleBox(canvas, frame(), view().up_rad() != 0.0);
    const std::optional<std::size_t> dragged =
        m_gesture == Gesture::Handle ? std::optional(m_handle) : std::nullopt;
    drawHandles(canvas, m_scene, dragged, m_handleFrom);
    drawTools(canvas, m_tools, frame(), ownShip());
    if (!any)
        drawEmptyNote(canvas, {tr("No area is open."), tr("Choose a lesson, or an area in the editor.")});
    painter.setClipping(false);
    drawReadout(canvas, stripArea(), readout());
    if (!hasFocus()) return;
    painter.setPen(QPen(canvas.palette.tool, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0));
}

void ChartWidget::resizeEvent(QResizeEvent* event) {
    m_camera.setSize(chartArea().size());
    if (m_whole) fitArea();
    QWidget::resizeEvent(event);
}

void ChartWidget::showCursor() {
    setCursor(m_gesture == Gesture::Pan ? Qt::ClosedHandCursor : Qt::CrossCursor);
}

/// The direction a new rule takes: of the leg of the route it is laid on, else the own ship's heading.
double ChartWidget::directionNear(QPointF at) const {
    const core::NorthEast p = view().toChart(at);
    const auto& waypoints = m_scene.route.waypoints;
    for (std::size_t i = 1; i < waypoints.size(); ++i) {
        const core::Segment leg{waypoints[i - 1].position, waypoints[i].position};
        if (core::distanceTo(leg, p) <= view().toMetres(kReach_px)) return core::bearing_rad(leg.a, leg.b);
    }
    return m_scene.ownShips.empty() ? 0.0 : m_scene.ownShips.front().heading_rad;
}

void ChartWidget::beginTool(QPointF at) {
    m_gesture = Gesture::Tool;
    if (m_tools.tool() == ChartTools::Tool::ParallelRule) {
        m_tools.beginRule(view().toChart(at), directionNear(at));
        return;
    }
    const ChartPick pick = pickAt(at);
    const bool own = pick.kind == ChartPick::Kind::OwnShip && pick.index == 0;
    m_tools.beginRange(own ? pick.position : view().toChart(at), own);
}

void ChartWidget::mousePressEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (m_gesture != Gesture::None || !chartArea().contains(at)) return;
    m_pressedAt = m_lastAt = at;
    if (event->button() == Qt::MiddleButton) {
        m_gesture = Gesture::Pan;
    } else if (event->button() == Qt::LeftButton) {
        const std::optional<std::size_t> handle = handleAt(at);
        if (handle) {
            m_gesture = Gesture::Handle;
            m_handle = *handle;
            m_handleFrom = m_scene.handles[m_handle].position;
        } else if (m_tools.tool() != ChartTools::Tool::None) {
            beginTool(at);
        } else {
            m_gesture = Gesture::Press;
        }
    }
    showCursor();
    update();
}

void ChartWidget::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (m_gesture == Gesture::Press &&
        std::hypot(at.x() - m_pressedAt.x(), at.y() - m_pressedAt.y()) >= kDragFrom_px) {
        m_gesture = Gesture::Pan;
        showCursor();
    }
    if (m_gesture == Gesture::Pan) {
        const bool followed = m_camera.following();
        m_camera.pan(at - m_lastAt);
        afterMoving(followed);
    }
    m_lastAt = at;
    const core::NorthEast place = view().toChart(at);
    if (m_gesture == Gesture::Tool) m_tools.drag(place, event->modifiers().testFlag(Qt::ShiftModifier));
    if (m_gesture == Gesture::Handle) dragHandle(place);
    m_cursor.reset();
    if (chartArea().contains(at)) {
        m_cursor = place;
        Q_EMIT cursorMoved(place);
    }
    update();
}

void ChartWidget::dragHandle(core::NorthEast to) {
    ChartHandle& handle = m_scene.handles[m_handle];
    handle.position = to;
    Q_EMIT handleDragged(handle.id, to);
}

void ChartWidget::mouseReleaseEvent(QMouseEvent* event) {
    const Gesture ended = std::exchange(m_gesture, Gesture::None);
    showCursor();
    update();
    if (ended == Gesture::Tool) m_tools.release();
    if (ended == Gesture::Handle) {
        const ChartHandle& handle = m_scene.handles[m_handle];
        if (handle.position != m_handleFrom) return Q_EMIT handleMoved(handle.id, handle.position);
        Q_EMIT picked(pickAt(event->position()));
    }
    if (ended != Gesture::Press) return;
    const ChartPick pick = pickAt(event->position());
    if (!pick.text.isEmpty()) QToolTip::showText(event->globalPosition().toPoint(), pick.text, this);
    Q_EMIT picked(pick);
    Q_EMIT clicked(view().toChart(event->position()));
}

void ChartWidget::leaveEvent(QEvent* event) {
    m_cursor.reset();
    update();
    QWidget::leaveEvent(event);
}

void ChartWidget::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    if (notches == 0.0 || !chartArea().contains(event->position())) return;
    m_camera.zoom(event->position(), std::pow(kZoomStep, notches));
    m_cursor = view().toChart(event->position());
    event->accept();
    afterMoving(following());
}

bool ChartWidget::cancel() {
    if (m_gesture == Gesture::Handle) {
        dragHandle(m_handleFrom);
        m_gesture = Gesture::None;
        return true;
    }
    const ChartTools::Tool before = m_tools.tool();
    const bool any = m_tools.cancel();
    if (m_gesture == Gesture::Tool) m_gesture = Gesture::None;
    if (m_tools.tool() != before) Q_EMIT toolChanged(m_tools.tool());
    return any;
}

void ChartWidget::keyPressEvent(QKeyEvent* event) {
    const double step = kPanStep * width();
    const bool followed = m_camera.following();
    switch (event->key()) {
        case Qt::Key_Left:
            m_camera.pan({step, 0.0});
            break;
        case Qt::Key_Right:
            m_camera.pan({-step, 0.0});
            break;
        case Qt::Key_Up:
            m_camera.pan({0.0, step});
            break;
        case Qt::Key_Down:
            m_camera.pan({0.0, -step});
            break;
        case Qt::Key_Plus:
        case Qt::Key_Equal:  // the same key without Shift on many keyboards
            zoomIn();
            break;
        case Qt::Key_Minus:
            zoomOut();
            break;
        case Qt::Key_Home:
            if (ownShip()) m_camera.follow(true);
            break;
        case Qt::Key_Escape:
            event->setAccepted(cancel());
            showCursor();
            update();
            return;
        default:
            QWidget::keyPressEvent(event);
            return;
    }
    showCursor();
    afterMoving(followed);
}

bool ChartWidget::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString tip = tipAt(help->pos());
    tip.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), tip, this);
    return true;
}

}  // namespace sagara::ui
