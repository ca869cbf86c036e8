#include "ui/debrief/Timeline.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <QWheelEvent>
#include <cmath>

#include "ui/debrief/MarkSigns.h"
#include "ui/run/RunTexts.h"
#include "ui/theme/ThemeColours.h"

namespace sagara::ui {
namespace {

constexpr int kLanes = 4;
constexpr double kReach_px = 9.0;

int laneOf(MarkKind kind) {
    switch (kind) {
        case MarkKind::Task:
            return 0;
        case MarkKind::Deduction:
        case MarkKind::Failure:
            return 1;
        case MarkKind::Event:
        case MarkKind::Weather:
            return 2;
        case MarkKind::Note:
            return 3;
    }
    return 2;
}

}  // namespace

Timeline::Timeline(TimeAxis& axis, QWidget* parent) : QWidget(parent), m_axis(axis) {
    setObjectName(QStringLiteral("timeline"));
    setAccessibleName(tr("Timeline"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&axis, &TimeAxis::rangeChanged, this, qOverload<>(&QWidget::update));
    connect(&axis, &TimeAxis::cursorChanged, this, qOverload<>(&QWidget::update));
}

void Timeline::setColours(PaletteName name) {
    m_colours = name;
    update();
}

void Timeline::setMarks(std::vector<DebriefMark> marks) {
    m_marks = std::move(marks);
    update();
}

void Timeline::setBranch(std::optional<core::SimTime> from) {
    m_branch = from;
    update();
}

double Timeline::laneHeight_px() const { return 1.15 * fontMetrics().height(); }
double Timeline::laneMiddle_px(int lane) const {
    return 1.4 * fontMetrics().height() + (lane + 0.5) * laneHeight_px();
}
QSize Timeline::sizeHint() const {
    return {640, static_cast<int>(std::ceil(laneMiddle_px(kLanes - 1) + 0.5 * laneHeight_px() + 3.0))};
}

QPointF Timeline::placeOf(const DebriefMark& mark) const {
    return {m_axis.x(mark.time.seconds(), width()), laneMiddle_px(laneOf(mark.kind))};
}

const DebriefMark* Timeline::markAt(QPointF at) const {
    const DebriefMark* found = nullptr;
    double nearest_px = kReach_px;
    for (const DebriefMark& mark : m_marks) {
        const QPointF off = placeOf(mark) - at;
        if (std::abs(off.y()) > 0.5 * laneHeight_px() || std::abs(off.x()) > nearest_px) continue;
        nearest_px = std::abs(off.x());
        found = &mark;
    }
    return found;
}

void Timeline::paintEvent(QPaintEvent*) {
    const ThemeColours& c = themeColours(m_colours);
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    p.fillRect(rect(), c.surface);
    const double right_px = width() - TimeAxis::kRight_px, line_px = fontMetrics().height();
    const double top_px = 1.3 * line_px, bottom_px = height() - 2.0;
    const QString names[kLanes] = {tr("Tasks"), tr("Deductions"), tr("Events"), tr("Notes")};
    for (int lane = 0; lane < kLanes; ++lane) {
        const double y = laneMiddle_px(lane);
        p.setPen(c.text);
        p.drawText(QRectF(6, y - line_px, TimeAxis::kLeft_px - 12, 2 * line_px),
                   Qt::AlignVCenter | Qt::AlignLeft, names[lane]);
        p.setPen(QPen(c.line, 1));
        p.drawLine(QPointF(TimeAxis::kLeft_px, y), QPointF(right_px, y));
    }
    if (m_branch) {
        QColor shade = c.series[1];
        shade.setAlpha(40);
        const double from_px = std::max(TimeAxis::kLeft_px, m_axis.x(m_branch->seconds(), width()));
        p.fillRect(QRectF(from_px, top_px, right_px - from_px, bottom_px - top_px), shade);
    }
    const double step_s = m_axis.step_s(width(), 6.0 * fontMetrics().averageCharWidth() + 24.0);
    for (double t = std::ceil(m_axis.from_s() / step_s) * step_s; t <= m_axis.to_s() + 1e-6; t += step_s) {
        const double x = m_axis.x(t, width());
        p.setPen(QPen(c.line, 1));
        p.drawLine(QPointF(x, top_px), QPointF(x, bottom_px));
        p.setPen(c.quietText);
        p.drawText(QRectF(x - 60, 1, 120, line_px), Qt::AlignCenter, axisTime(t));
    }
    p.setClipRect(QRectF(TimeAxis::kLeft_px - 8, 0, right_px - TimeAxis::kLeft_px + 16, height()));
    for (const DebriefMark& mark : m_marks) drawMarkSign(p, placeOf(mark), mark.kind, 0.36 * line_px, c);
    drawPoints(p);
    const double x = m_axis.x(m_axis.cursor().seconds(), width());
    p.setPen(QPen(c.accent, 2));
    p.drawLine(QPointF(x, 2), QPointF(x, bottom_px));
    QPainterPath head;
    head.addPolygon(QPolygonF({{x - 6, 0.0}, {x + 6, 0.0}, {x, 9.0}}));
    p.fillPath(head, c.accent);
    p.setClipping(false);
    if (hasFocus()) {
        p.setPen(QPen(c.focus, 2));
        p.setBrush(Qt::NoBrush);
        p.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
    }
}

/// What deductions cost, beside their signs; of those that lie close together the sum.
void Timeline::drawPoints(QPainter& p) const {
    const double line_px = fontMetrics().height(), room_px = 2.6 * line_px;
    std::vector<const DebriefMark*> deductions;
    for (const DebriefMark& mark : m_marks)
        if (mark.kind == MarkKind::Deduction) deductions.push_back(&mark);
    p.setPen(markColour(MarkKind::Deduction, themeColours(m_colours)));
    double sum = 0.0;
    for (std::size_t i = 0; i < deductions.size(); ++i) {
        const QPointF at = placeOf(*deductions[i]);
        sum += deductions[i]->points;
        if (i + 1 < deductions.size() && placeOf(*deductions[i + 1]).x() - at.x() < room_px) continue;
        p.drawText(QRectF(at.x() + 0.5 * line_px, at.y() - 0.5 * line_px, 4.0 * line_px, line_px),
                   Qt::AlignVCenter | Qt::AlignLeft, QStringLiteral("−%1").arg(sum, 0, 'f', 0));
        sum = 0.0;
    }
}

void Timeline::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return;
    const DebriefMark* const mark = markAt(event->position());
    Q_EMIT m_axis.picked(mark != nullptr ? mark->time : m_axis.timeAt(event->position().x(), width()));
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton)
        Q_EMIT m_axis.picked(m_axis.timeAt(event->position().x(), width()));
    setCursor(markAt(event->position()) != nullptr ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void Timeline::mouseDoubleClickEvent(QMouseEvent*) { m_axis.showAll(); }

void Timeline::wheelEvent(QWheelEvent* event) {
    const double about_s = m_axis.time_s(event->position().x(), width());
    m_axis.zoom(about_s, std::pow(1.25, event->angleDelta().y() / 120.0));
    event->accept();
}

void Timeline::keyPressEvent(QKeyEvent* event) {
    const double step_s = event->modifiers() & Qt::ShiftModifier ? 10.0 : 1.0;
    if (event->modifiers() & Qt::ControlModifier) return QWidget::keyPressEvent(event);
    if (event->key() == Qt::Key_Left) return Q_EMIT stepWanted(-step_s);
    if (event->key() == Qt::Key_Right) return Q_EMIT stepWanted(step_s);
    QWidget::keyPressEvent(event);
}

bool Timeline::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* const help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
    return true;
}

/// The marks under the mouse, or what can be done here.
QString Timeline::tipAt(QPointF at) const {
    constexpr int kMost = 6;
    QStringList lines;
    int more = 0;
    for (const DebriefMark& mark : m_marks) {
        const QPointF off = placeOf(mark) - at;
        if (std::abs(off.y()) > 0.5 * laneHeight_px() || std::abs(off.x()) > kReach_px) continue;
        if (lines.size() == kMost)
            ++more;
        else
            lines << QStringLiteral("%1  %2").arg(elapsed(mark.time), mark.text);
    }
    if (more > 0) lines << tr("and %1 more: zoom with the wheel").arg(more);
    if (!lines.isEmpty()) return lines.join(QLatin1Char('\n'));
    return tr("%1: click to go there; the wheel zooms, a double click shows all")
        .arg(elapsed(m_axis.timeAt(at.x(), width())));
}

}  // namespace sagara::ui
