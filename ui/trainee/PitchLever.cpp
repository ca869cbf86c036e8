#include "ui/trainee/PitchLever.h"

#include <QFontInfo>
#include <algorithm>
#include <cmath>

namespace sagara::ui::console {
namespace {

constexpr double kStep = 0.05;
constexpr double kHalfKnob = 3.5;  ///< in unit(): the knob stays within the track

double rounded(double pitch) { return std::round(pitch / kStep) * kStep; }

QString percent(double pitch) {
    const long value = std::lround(100.0 * pitch);
    return (value < 0 ? QStringLiteral("−%1 %") : QStringLiteral("%1 %")).arg(std::abs(value));
}

}  // namespace

PitchLever::PitchLever(const QString& shaft, const core::PitchControl& limits, QWidget* parent)
    : Lever(tr("Pitch"), 0.4, parent), m_limits(limits) {
    setAccessibleName(tr("Pitch, %1").arg(shaft));
    setToolTip(
        tr("Pitch of the %1 propeller, %2 to %3 of the design pitch: click or drag, up is ahead; mouse "
           "wheel or ↑ ↓ 5 %; keys U and I all of them. It holds until the next order of the telegraph; "
           "double click gives it back at once. The bar is the pitch as it is")
            .arg(shaft, percent(limits.least), percent(limits.most)));
}

void PitchLever::setOrder(double pitch, bool byHand) {
    if (held() || (pitch == m_order && byHand == m_byHand)) return;
    m_order = pitch;
    m_byHand = byHand;
    update();
}

void PitchLever::setPitch(double pitch) {
    if (pitch == m_pitch) return;
    m_pitch = pitch;
    update();
}

double PitchLever::within(double pitch) const { return std::clamp(pitch, m_limits.least, m_limits.most); }

void PitchLever::moveTo(double pitch) {
    m_order = within(rounded(pitch));
    m_byHand = true;
    update();
    Q_EMIT ordered(m_order);
}

QRectF PitchLever::track() const {
    return {0.13 * width(), 23.0 * unit(), 0.26 * width(), height() - 50.0 * unit()};
}

double PitchLever::yOf(double pitch) const {
    const QRectF t = track().adjusted(0.0, kHalfKnob * unit(), 0.0, -kHalfKnob * unit());
    return t.bottom() - (pitch - m_limits.least) / (m_limits.most - m_limits.least) * t.height();
}

void PitchLever::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    drawFrame(painter);
    const QRectF t = track();
    const double letters = QFontInfo(font()).pixelSize();
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours().section);
    painter.drawRoundedRect(t, 3.0, 3.0);
    const double none = yOf(0.0), now = yOf(within(m_pitch));
    painter.setBrush(m_pitch < 0.0 ? colours().caution : colours().accent);
    painter.drawRect(
        QRectF(t.left() + 0.3 * t.width(), std::min(none, now), 0.4 * t.width(), std::abs(none - now)));
    const double marks = t.right() + 0.07 * width() + 2.0;
    for (int mark = -100; mark <= 200; mark += 25) {
        const double pitch = 0.01 * mark;
        if (pitch < m_limits.least || pitch > m_limits.most) continue;
        const bool zero = mark == 0;
        painter.setPen(QPen(zero ? colours().tick : colours().quietTick, zero ? 1.6 : 1.0));
        painter.drawLine(QPointF(marks, yOf(pitch)), QPointF(marks + 2.5 * unit(), yOf(pitch)));
        if (mark % 50 != 0) continue;
        const QRectF word(marks + 2.0 + 2.5 * unit(), yOf(pitch) - 5.0 * unit(),
                          width() - marks - 5.0 - 2.5 * unit(), 10.0 * unit());
        drawWords(painter, word, Qt::AlignLeft | Qt::AlignVCenter, QString::number(std::abs(mark)),
                  0.8 * letters, colours().quietText);
    }
    prepareKnob(painter);
    painter.drawRoundedRect(QRectF(t.left() - 0.07 * width(), yOf(within(m_order)) - kHalfKnob * unit(),
                                   t.width() + 0.14 * width(), 2.0 * kHalfKnob * unit()),
                            3.0, 3.0);
    const QRectF line(5.0, t.top() - 10.5 * unit(), width() - 10.0, 10.0 * unit());
    drawWords(painter, line, Qt::AlignLeft | Qt::AlignVCenter, m_byHand ? tr("by hand") : tr("ahead"),
              0.9 * letters, m_byHand ? colours().setValue : colours().quietText);
    const double foot = t.bottom() + 1.5 * unit(), row = 0.5 * (height() - foot - 3.0);
    const QRectF below(5.0, foot, width() - 10.0, row);
    drawWords(painter, below, Qt::AlignCenter, percent(m_order), 1.2 * letters, colours().setValue, true);
    drawWords(painter, below.translated(0.0, row), Qt::AlignCenter, tr("is %1").arg(percent(m_pitch)),
              0.9 * letters, colours().text);
}

void PitchLever::take(QPointF p) {
    const double least = yOf(m_limits.least), share = (least - p.y()) / (least - yOf(m_limits.most));
    const double pitch = within(rounded(m_limits.least + share * (m_limits.most - m_limits.least)));
    if (pitch != m_order || !held()) moveTo(pitch);
}

void PitchLever::stepUp(int steps) { moveTo(m_order + steps * kStep); }

bool PitchLever::rest() {
    Q_EMIT givenBack();
    return true;
}

}  // namespace sagara::ui::console
