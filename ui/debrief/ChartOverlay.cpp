#include "ui/debrief/ChartOverlay.h"

#include <QEvent>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/debrief/MarkSigns.h"
#include "ui/debrief/TimeAxis.h"
#include "ui/run/RunTexts.h"
#include "ui/theme/ThemeColours.h"
#include "ui/widgets/ChartWidget.h"
#include "ui/widgets/ShipShape.h"

namespace sagara::ui {
namespace {

constexpr double kSign_px = 6.0, kReach_px = 10.0;
constexpr double kLeastShip_px = 16.0;  ///< drawn no smaller

bool onChart(MarkKind kind) { return kind != MarkKind::Weather; }

}  // namespace

std::vector<OverlayTrack::Point> overlayPoints(const std::vector<core::TrackSample>& track) {
    std::vector<OverlayTrack::Point> points;
    for (std::size_t i = 0; i < track.size(); ++i) {
        const core::TrackSample& sample = track[i];
        const bool whole = sample.tick % core::kTicksPerSecond == 0 || i + 1 == track.size();
        if (whole && !sample.ships.empty())
            points.push_back({core::timeOfTick(sample.tick).seconds(), sample.ships[0].motion.position()});
    }
    return points;
}

ChartOverlay::ChartOverlay(ChartWidget& chart) : QWidget(&chart), m_chart(chart) {
    setObjectName(QStringLiteral("chart-overlay"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setGeometry(chart.rect());
    chart.installEventFilter(this);
}

void ChartOverlay::setColours(PaletteName name) {
    m_colours = name;
    update();
}

void ChartOverlay::setTracks(std::vector<OverlayTrack> tracks) {
    m_tracks = std::move(tracks);
    update();
}

void ChartOverlay::setMarks(const std::vector<DebriefMark>& marks) {
    m_marks.clear();
    for (const DebriefMark& mark : marks)
        if (onChart(mark.kind)) m_marks.push_back(mark);
    update();
}

void ChartOverlay::setShip(std::optional<OverlayShip> ship) {
    m_ship = std::move(ship);
    update();
}

QPointF ChartOverlay::placeOf(const DebriefMark& mark) const { return m_chart.view().toScreen(mark.place); }

const DebriefMark* ChartOverlay::markAt(QPointF at) const {
    const DebriefMark* found = nullptr;
    double nearest_px = kReach_px;
    for (const DebriefMark& mark : m_marks) {
        const QPointF off = placeOf(mark) - at;
        const double distance_px = std::hypot(off.x(), off.y());
        if (distance_px >= nearest_px) continue;
        nearest_px = distance_px;
        found = &mark;
    }
    return found;
}

void ChartOverlay::drawTrack(QPainter& p, const OverlayTrack& track) const {
    const ThemeColours& c = themeColours(m_colours);
    QColor colour = c.series[track.colour];
    if (track.faint) colour.setAlpha(150);
    p.setBrush(Qt::NoBrush);
    QPolygonF line;
    for (std::size_t i = 0; i < track.points.size(); ++i) {
        const QPointF at = m_chart.view().toScreen(track.points[i].position);
        const QPointF off = line.isEmpty() ? QPointF(99, 99) : at - line.back();
        if (std::abs(off.x()) + std::abs(off.y()) > 1.5 || i + 1 == track.points.size()) line << at;
    }
    p.setPen(QPen(colour, track.faint ? 1.4 : 2.2, track.faint ? Qt::DotLine : Qt::SolidLine));
    p.drawPolyline(line);
    if (!track.ticks || track.points.size() < 2) return;
    QPointF last(1e9, 1e9), lastWords(1e9, 1e9);
    for (std::size_t i = 1; i < track.points.size(); ++i) {
        const double minute = std::floor(track.points[i].time_s / 60.0);
        if (minute <= std::floor(track.points[i - 1].time_s / 60.0)) continue;
        const QPointF from = m_chart.view().toScreen(track.points[i - 1].position);
        const QPointF at = m_chart.view().toScreen(track.points[i].position), along = at - from;
        const double length = std::hypot(along.x(), along.y());
        if (length <= 0.0 || std::hypot(at.x() - last.x(), at.y() - last.y()) < 8.0) continue;
        last = at;
        const QPointF across = QPointF(-along.y(), along.x()) / length;
        p.setPen(QPen(colour, 1.6));
        p.drawLine(at - 4.0 * across, at + 4.0 * across);
        if (std::hypot(at.x() - lastWords.x(), at.y() - lastWords.y()) < 60.0) continue;
        lastWords = at;
        const QString words = axisTime(60.0 * minute);
        const double side = track.colour == 0 ? 1.0 : -1.0;  // two tracks: each on its own side
        QRectF box(0, 0, fontMetrics().horizontalAdvance(words) + 6, fontMetrics().height());
        box.moveCenter(at + (0.5 * box.width() + 5.0) * side * QPointF(std::abs(across.x()), across.y()));
        QColor back = c.surface;
        back.setAlpha(200);
        p.fillRect(box, back);
        p.drawText(box, Qt::AlignCenter, words);
    }
}

void ChartOverlay::drawShip(QPainter& p) const {
    if (!m_ship) return;
    const ThemeColours& c = themeColours(m_colours);
    const double scale =
        std::max(1.0, m_chart.view().toMetres(kLeastShip_px) / std::max(1.0, m_ship->length_m));
    QPolygonF outline;
    for (const core::NorthEast corner :
         shipOutline(m_ship->position, m_ship->heading_rad, scale * m_ship->length_m, scale * m_ship->beam_m))
        outline << m_chart.view().toScreen(corner);
    p.setPen(QPen(c.series[m_ship->colour], 1.8));
    QColor fill = c.series[m_ship->colour];
    fill.setAlpha(90);
    p.setBrush(fill);
    p.drawPolygon(outline);
    const QPointF at = m_chart.view().toScreen(m_ship->position);
    QRectF box(0, 0, fontMetrics().horizontalAdvance(m_ship->name) + 8, fontMetrics().height() + 2);
    box.moveTopLeft(at + QPointF(12, 8));
    QColor back = c.surface;
    back.setAlpha(215);
    p.fillRect(box, back);
    p.setPen(c.series[m_ship->colour]);
    p.drawText(box, Qt::AlignCenter, m_ship->name);
}

void ChartOverlay::paintEvent(QPaintEvent*) {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    p.setClipRect(QRectF(QPointF(), m_chart.view().size()));
    for (const OverlayTrack& track : m_tracks) drawTrack(p, track);
    for (const DebriefMark& mark : m_marks)
        drawMarkSign(p, placeOf(mark), mark.kind, kSign_px, themeColours(m_colours));
    drawShip(p);
}

bool ChartOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_chart && event->type() == QEvent::Resize) setGeometry(m_chart.rect());
    if (watched == &m_chart && event->type() == QEvent::MouseButtonPress)
        m_pressedAt = static_cast<QMouseEvent*>(event)->position();
    if (watched == &m_chart && event->type() == QEvent::MouseButtonRelease) {
        const QPointF at = static_cast<QMouseEvent*>(event)->position();
        const DebriefMark* const mark = markAt(at);
        if (mark != nullptr && (at - m_pressedAt).manhattanLength() < 4.0) Q_EMIT markPicked(mark->time);
    }
    if (watched == &m_chart && event->type() == QEvent::ToolTip) {
        const auto* const help = static_cast<QHelpEvent*>(event);
        if (const DebriefMark* const mark = markAt(help->pos())) {
            QToolTip::showText(help->globalPos(),
                               QStringLiteral("%1  %2").arg(elapsed(mark->time), mark->text), &m_chart);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace sagara::ui
