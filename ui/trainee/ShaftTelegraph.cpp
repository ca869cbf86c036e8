#include "ui/trainee/ShaftTelegraph.h"

#include <QFontInfo>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::ui::console {
namespace {

using core::TelegraphStep;
constexpr int kLast = static_cast<int>(core::kTelegraphSteps) - 1;

}  // namespace

QString telegraphStepText(TelegraphStep step) {
    switch (step) {
        case TelegraphStep::FullAhead:
            return ShaftTelegraph::tr("Full ahead");
        case TelegraphStep::HalfAhead:
            return ShaftTelegraph::tr("Half ahead");
        case TelegraphStep::SlowAhead:
            return ShaftTelegraph::tr("Slow ahead");
        case TelegraphStep::DeadSlowAhead:
            return ShaftTelegraph::tr("Dead slow ahead");
        case TelegraphStep::Stop:
            return ShaftTelegraph::tr("Stop");
        case TelegraphStep::DeadSlowAstern:
            return ShaftTelegraph::tr("Dead slow astern");
        case TelegraphStep::SlowAstern:
            return ShaftTelegraph::tr("Slow astern");
        case TelegraphStep::HalfAstern:
            return ShaftTelegraph::tr("Half astern");
        case TelegraphStep::FullAstern:
            return ShaftTelegraph::tr("Full astern");
    }
    return {};
}

ShaftTelegraph::ShaftTelegraph(const QString& name, const core::TelegraphTable& table, QWidget* parent)
    : Lever(name, 0.7, parent), m_table(table) {
    setToolTip(tr("Telegraph of the %1 shaft: click a step or drag; mouse wheel or ↑ ↓ one step. The bar is "
                  "the shaft as it turns, in rpm; Page Up and Page Down move all levers")
                   .arg(name));
}

void ShaftTelegraph::setOrder(double order_rps) {
    if (held()) return;
    const auto nearest = std::min_element(m_table.begin(), m_table.end(), [&](double a, double b) {
        return std::abs(a - order_rps) < std::abs(b - order_rps);
    });
    m_step = static_cast<TelegraphStep>(nearest - m_table.begin());
    update();
}

void ShaftTelegraph::setShaft(double speed_rps, double drives_rps) {
    m_speed_rps = speed_rps;
    m_drives_rps = drives_rps;
    update();
}

void ShaftTelegraph::setNote(const QString& note) {
    if (note == m_note) return;
    m_note = note;
    update();
}

void ShaftTelegraph::moveTo(TelegraphStep step) {
    m_step = step;
    update();
    Q_EMIT ordered(step);
}

void ShaftTelegraph::moveBy(int steps) {
    const int to = std::clamp(static_cast<int>(m_step) + steps, 0, kLast);
    if (to != static_cast<int>(m_step)) moveTo(static_cast<TelegraphStep>(to));
}

QRectF ShaftTelegraph::track() const {
    return {0.13 * width(), 23.0 * unit(), 0.16 * width(), height() - 35.0 * unit()};
}

double ShaftTelegraph::yOf(double step) const {
    const QRectF t = track();
    return t.bottom() - (step + 0.5) / static_cast<double>(core::kTelegraphSteps) * t.height();
}

double ShaftTelegraph::placeOf(double speed_rps) const {
    for (std::size_t i = 1; i < m_table.size(); ++i)
        if (speed_rps <= m_table[i]) {
            const double part = (speed_rps - m_table[i - 1]) / (m_table[i] - m_table[i - 1]);
            return std::max(0.0, static_cast<double>(i - 1) + part);
        }
    return kLast;
}

void ShaftTelegraph::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    drawFrame(painter);
    const QRectF t = track();
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours().section);
    painter.drawRoundedRect(t, 3.0, 3.0);
    const double stop = yOf(static_cast<int>(TelegraphStep::Stop)), now = yOf(placeOf(m_drives_rps));
    painter.setBrush(m_drives_rps < 0.0 ? colours().caution : colours().accent);
    painter.drawRect(
        QRectF(t.left() + 0.3 * t.width(), std::min(stop, now), 0.4 * t.width(), std::abs(stop - now)));
    const std::array names{tr("Full"),      tr("Half"), tr("Slow"), tr("Dead slow"), tr("Stop"),
                           tr("Dead slow"), tr("Slow"), tr("Half"), tr("Full")};
    const double row = t.height() / static_cast<double>(core::kTelegraphSteps);
    for (int step = 0; step <= kLast; ++step) {
        const bool chosen = step == static_cast<int>(m_step);
        const QRectF words(0.42 * width(), yOf(step) - 0.5 * row, 0.55 * width(), row);
        if (chosen) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(colours().selected);
            painter.drawRoundedRect(words.adjusted(-0.03 * width(), 0.5, 0.0, -0.5), 2.0, 2.0);
        }
        const QColor plain = step == 4 ? colours().text : colours().quietText;
        drawWords(painter, words, Qt::AlignLeft | Qt::AlignVCenter, names[static_cast<std::size_t>(step)],
                  0.74 * row, chosen ? colours().onSelected : plain, chosen);
    }
    const double y = yOf(static_cast<int>(m_step));
    prepareKnob(painter);
    painter.drawRoundedRect(
        QRectF(t.left() - 0.06 * width(), y - 3.5 * unit(), t.width() + 0.12 * width(), 7.0 * unit()), 3.0,
        3.0);
    const double letters = QFontInfo(font()).pixelSize();
    const QRectF top(0.36 * width(), 3.0, 0.6 * width(), 1.5 * letters);
    drawWords(painter, top, Qt::AlignRight | Qt::AlignVCenter,
              tr("%1 rpm").arg(QString::number(std::lround(m_speed_rps / core::kRpm_rps))), letters,
              colours().text, true);
    const QRectF side(0.05 * width(), 0.0, 0.9 * width(), 10.0 * unit());
    drawWords(painter, side.translated(0.0, t.top() - 10.5 * unit()), Qt::AlignLeft | Qt::AlignVCenter,
              tr("ahead"), 0.9 * letters, colours().quietText);
    drawWords(painter, side.translated(0.0, t.bottom() + 0.5 * unit()), Qt::AlignLeft | Qt::AlignVCenter,
              tr("astern"), 0.9 * letters, colours().quietText);
    const QRectF foot(0.36 * width(), t.bottom() + 0.5 * unit(), 0.6 * width(), 10.0 * unit());
    drawWords(painter, foot, Qt::AlignRight | Qt::AlignVCenter, m_note, 0.9 * letters, colours().text);
}

void ShaftTelegraph::take(QPointF p) {
    const QRectF t = track();
    const double place = (t.bottom() - p.y()) / t.height() * static_cast<double>(core::kTelegraphSteps);
    const auto step = static_cast<TelegraphStep>(std::clamp(static_cast<int>(std::floor(place)), 0, kLast));
    // A click on the step it has is an order too: it takes back a pitch that was set by hand.
    if (step != m_step || !held()) moveTo(step);
}

}  // namespace sagara::ui::console
