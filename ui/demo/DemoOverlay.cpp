#include "ui/demo/DemoOverlay.h"

#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <algorithm>
#include <cmath>

namespace sagara::ui {
namespace {

constexpr int kSeeThrough = 205;  ///< alpha of the panels

QPolygonF star(QPointF centre, double radius) {
    QPolygonF shape;
    for (int i = 0; i < 10; ++i) {
        const double angle = -M_PI / 2.0 + i * M_PI / 5.0, r = i % 2 == 0 ? radius : 0.42 * radius;
        shape << centre + QPointF(r * std::cos(angle), r * std::sin(angle));
    }
    return shape;
}

QString minutes(double left_s) {
    const auto s = static_cast<int>(std::ceil(left_s));
    return QStringLiteral("%1:%2").arg(s / 60).arg(s % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace

DemoOverlay::DemoOverlay(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("demo-overlay"));
    const std::array<std::pair<QString, const char*>, 5> texts{{{tr("◀  Port\nkey ←"), "demo-port"},
                                                                {tr("Starboard  ▶\nkey →"), "demo-starboard"},
                                                                {tr("Midships\nkey Home"), "demo-midships"},
                                                                {tr("Faster\nkey PgUp"), "demo-faster"},
                                                                {tr("Slower\nkey PgDn"), "demo-slower"}}};
    for (std::size_t i = 0; i < texts.size(); ++i) {
        m_buttons[i] = new QPushButton(texts[i].first, this);
        m_buttons[i]->setObjectName(QString::fromLatin1(texts[i].second));
        m_buttons[i]->setFocusPolicy(Qt::NoFocus);
        m_buttons[i]->setAutoRepeat(i < 2);
        m_buttons[i]->setAutoRepeatDelay(400);
        m_buttons[i]->setAutoRepeatInterval(250);
        m_buttons[i]->hide();
        connect(m_buttons[i], &QPushButton::pressed, this,
                [this, i] { Q_EMIT pressed(static_cast<int>(i)); });
    }
}

const ThemeColours& DemoOverlay::colours() const {
    // Light panels would outshine the picture: the day's are those of dusk.
    return themeColours(m_palette == PaletteName::Night ? PaletteName::Night : PaletteName::Dusk);
}

void DemoOverlay::setColours(PaletteName palette) {
    m_palette = palette;
    layOutButtons();
    update();
}

void DemoOverlay::display(DemoShown shown) {
    m_shown = std::move(shown);
    for (QPushButton* button : m_buttons)
        button->setVisible(m_shown.guide.has_value() && m_shown.curtain.isEmpty());
    update();
}

double DemoOverlay::unit() const { return std::min(height() / 100.0, width() / 160.0); }

QFont DemoOverlay::font(double units, bool bold) const {
    QFont made = QWidget::font();
    made.setPixelSize(std::max(8, static_cast<int>(std::lround(units * unit()))));
    made.setBold(bold);
    return made;
}

QRectF DemoOverlay::band() const {
    const double high = 21.0 * unit();
    return {0.0, height() - high, 1.0 * width(), high};
}

QRectF DemoOverlay::guideFrame() const {
    const double wide = 60.0 * unit(), high = 62.0 * unit();
    return {width() - wide - 3.0 * unit(), 9.0 * unit(), wide, high};
}

void DemoOverlay::panel(QPainter& painter, const QRectF& frame) const {
    QColor fill = colours().window;
    fill.setAlpha(kSeeThrough);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawRoundedRect(frame, 1.6 * unit(), 1.6 * unit());
}

void DemoOverlay::paintBrand(QPainter& painter) const {
    const double u = unit();
    painter.setFont(font(6.0, true));
    const QFontMetricsF large(painter.font());
    const QFontMetricsF small(font(3.0));
    const double wide =
        std::max({large.horizontalAdvance(tr("Sagara")), small.horizontalAdvance(m_shown.lesson),
                  small.horizontalAdvance(m_shown.camera)});
    const QRectF frame(3.0 * u, 3.0 * u, wide + 5.0 * u, 17.5 * u);
    panel(painter, frame);
    painter.setPen(colours().text);
    painter.drawText(QRectF(frame.left() + 2.5 * u, frame.top() + 1.2 * u, wide + u, 7.5 * u),
                     Qt::AlignLeft | Qt::AlignVCenter, tr("Sagara"));
    painter.setFont(font(3.0));
    painter.drawText(QRectF(frame.left() + 2.5 * u, frame.top() + 8.6 * u, wide + u, 4.0 * u),
                     Qt::AlignLeft | Qt::AlignVCenter, m_shown.lesson);
    painter.setPen(colours().quietText);
    painter.drawText(QRectF(frame.left() + 2.5 * u, frame.top() + 12.3 * u, wide + u, 4.0 * u),
                     Qt::AlignLeft | Qt::AlignVCenter, m_shown.camera);
}

void DemoOverlay::paintBand(QPainter& painter) const {
    const double u = unit(), margin = 4.0 * u;
    const QRectF frame = band();
    QColor fill = colours().window;
    fill.setAlpha(kSeeThrough);
    painter.fillRect(frame, fill);
    painter.fillRect(QRectF(0.0, frame.top(), width(), 0.4 * u), colours().accent);
    painter.setPen(colours().text);
    painter.setFont(font(5.2, true));
    const QRectF title(margin, frame.top() + 1.4 * u, width() - 2.0 * margin, 7.5 * u);
    painter.drawText(
        title, Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetricsF(painter.font()).elidedText(m_shown.caption.title, Qt::ElideRight, title.width()));
    // Columns as wide as what stands in them needs, over the whole width.
    const auto& figures = m_shown.caption.figures;
    const QFont valueFont = font(3.9, true), nameFont = font(2.8);
    std::vector<double> wide;
    double all = 0.0;
    for (const DemoFigure& figure : figures) {
        wide.push_back(std::max(QFontMetricsF(valueFont).horizontalAdvance(figure.value),
                                QFontMetricsF(nameFont).horizontalAdvance(figure.name)));
        all += wide.back();
    }
    const double room = width() - 2.0 * margin;
    const double gap = figures.size() < 2 ? 0.0
                                          : std::clamp((room - all) / static_cast<double>(figures.size() - 1),
                                                       1.0 * u, 9.0 * u);
    double left = margin;
    for (qsizetype i = 0; i < figures.size(); ++i) {
        const double w = wide[static_cast<std::size_t>(i)] + u;
        painter.setFont(nameFont);
        painter.setPen(colours().quietText);
        painter.drawText(QRectF(left, frame.top() + 9.6 * u, w, 4.0 * u), Qt::AlignLeft | Qt::AlignVCenter,
                         figures[i].name);
        painter.setFont(valueFont);
        painter.setPen(colours().text);
        painter.drawText(QRectF(left, frame.top() + 13.4 * u, w, 5.6 * u), Qt::AlignLeft | Qt::AlignVCenter,
                         figures[i].value);
        left += w - u + gap;
    }
}

void DemoOverlay::paintInvitation(QPainter& painter) const {
    const double u = unit();
    const QString text = tr("Take the helm: press any key");
    painter.setFont(font(4.6, true));
    const double wide = QFontMetricsF(painter.font()).horizontalAdvance(text) + 8.0 * u, high = 8.6 * u;
    const QRectF frame((width() - wide) / 2.0, band().top() - high - 3.0 * u, wide, high);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours().selected);
    painter.drawRoundedRect(frame, high / 2.0, high / 2.0);
    painter.setPen(colours().onSelected);
    painter.drawText(frame, Qt::AlignCenter, text);
}

void DemoOverlay::paintGuide(QPainter& painter) const {
    const double u = unit();
    const QRectF frame = guideFrame();
    panel(painter, frame);
    const auto line = [&](double top, double high, const QString& text, const QFont& f, const QColor& colour,
                          int align) {
        painter.setFont(f);
        painter.setPen(colour);
        painter.drawText(
            QRectF(frame.left() + 3.0 * u, frame.top() + top * u, frame.width() - 6.0 * u, high * u),
            align | Qt::AlignVCenter,
            QFontMetricsF(f).elidedText(text, Qt::ElideRight, frame.width() - 6.0 * u));
    };
    const ThemeColours& c = colours();
    line(1.5, 7.0, tr("You have the helm"), font(4.6, true), c.text, Qt::AlignLeft);
    line(1.5, 7.0, minutes(m_shown.guide->left_s), font(4.6, true), c.text, Qt::AlignRight);
    line(8.0, 4.5, m_shown.guide->next, font(3.2), c.text, Qt::AlignLeft);
    line(49.0, 4.0, tr("Rudder"), font(3.0), c.quietText, Qt::AlignLeft);
    line(53.0, 6.0, m_shown.guide->rudder, font(3.5, true), c.text, Qt::AlignLeft);
    line(49.0, 4.0, tr("Engine"), font(3.0), c.quietText, Qt::AlignRight);
    line(53.0, 6.0, m_shown.guide->engine, font(3.5, true), c.text, Qt::AlignRight);
}

void DemoOverlay::layOutButtons() {
    const double u = unit();
    const QRectF frame = guideFrame();
    const double wide = 17.4 * u, high = 10.0 * u, gap = 0.9 * u;
    const double middle = frame.center().x() - wide / 2.0, top = frame.top() + 14.5 * u;
    const std::array<QPointF, 5> at{
        QPointF(middle - wide - gap, top + high + gap), QPointF(middle + wide + gap, top + high + gap),
        QPointF(middle, top + high + gap), QPointF(middle, top), QPointF(middle, top + 2.0 * (high + gap))};
    const ThemeColours& c = colours();
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i]->setGeometry(QRectF(at[i], QSizeF(wide, high)).toRect());
        m_buttons[i]->setStyleSheet(
            QStringLiteral(
                "QPushButton { color: %1; background: %2; border: 1px solid %3; border-radius: %4px;"
                " font-size: %5px; font-weight: bold; padding: 0; }"
                "QPushButton:pressed { background: %6; color: %7; }")
                .arg(c.text.name(), c.surface.name(), c.border.name())
                .arg(static_cast<int>(u))
                .arg(std::max(8, static_cast<int>(2.6 * u)))
                .arg(c.selected.name(), c.onSelected.name()));
    }
}

void DemoOverlay::paintVerdict(QPainter& painter) const {
    const double u = unit();
    const double wide = std::min(0.92 * width(), 124.0 * u);
    const QRectF frame((width() - wide) / 2.0, 22.0 * u, wide, 46.0 * u);
    panel(painter, frame);
    for (int i = 0; i < 5; ++i) {
        const QPointF centre(frame.center().x() + (i - 2) * 13.0 * u, frame.top() + 12.0 * u);
        const bool won = i < m_shown.verdict->stars;
        painter.setPen(QPen(won ? colours().caution : colours().border, 0.3 * u));
        painter.setBrush(won ? QBrush(colours().caution) : Qt::NoBrush);
        painter.drawPolygon(star(centre, 6.0 * u));
    }
    painter.setPen(colours().text);
    painter.setFont(font(4.6, true));
    painter.drawText(
        QRectF(frame.left() + 4.0 * u, frame.top() + 20.5 * u, frame.width() - 8.0 * u, 15.0 * u),
        Qt::AlignCenter | Qt::TextWordWrap, m_shown.verdict->sentence);
    painter.setFont(font(3.2));
    painter.setPen(colours().quietText);
    painter.drawText(QRectF(frame.left() + 4.0 * u, frame.top() + 37.0 * u, frame.width() - 8.0 * u, 6.0 * u),
                     Qt::AlignCenter, m_shown.verdict->sailed);
}

void DemoOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    if (!m_shown.curtain.isEmpty()) {
        painter.fillRect(rect(), colours().window);
        painter.setPen(colours().text);
        painter.setFont(font(6.0, true));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, m_shown.curtain);
        return;
    }
    paintBand(painter);
    paintBrand(painter);
    if (m_shown.invites) paintInvitation(painter);
    if (m_shown.guide) paintGuide(painter);
    if (m_shown.verdict) paintVerdict(painter);
}

void DemoOverlay::resizeEvent(QResizeEvent*) { layOutButtons(); }

}  // namespace sagara::ui
