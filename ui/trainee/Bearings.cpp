#include "ui/trainee/Bearings.h"

#include <QEvent>
#include <QFontInfo>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "ui/chart/Format.h"
#include "ui/widgets/ChartPalette.h"
#include "ui/widgets/ChartWidget.h"
#include "ui/widgets/ScreenText.h"

namespace sagara::ui::console {
namespace {

constexpr double kLine_m = 20.0 * core::kNauticalMile_m;

QString textOf(const Bearing& b, const QString& clock) {
    const double relative_deg = b.relative_rad / core::kDegree_rad;
    return BearingList::tr("%1   %2°T   %3 %4° rel.")
        .arg(clock, chart::bearing(b.true_rad / core::kDegree_rad),
             relative_deg < 0.0 ? QStringLiteral("P") : QStringLiteral("S"))
        .arg(std::lround(std::abs(relative_deg)), 3, 10, QLatin1Char('0'));
}

}  // namespace

BearingList::BearingList(QWidget* parent)
    : QWidget(parent), m_list(new QListWidget(this)), m_remove(new QPushButton(tr("Remove"), this)) {
    m_list->setObjectName(QStringLiteral("bearings"));
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setToolTip(
        tr("Time, true bearing in degrees, relative bearing. A line of position on the chart for each"));
    m_remove->setObjectName(QStringLiteral("bearing-remove"));
    m_remove->setToolTip(tr("Remove the chosen bearings, or all when none is chosen"));
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(6, 4, 6, 4);
    row->addWidget(m_list, 1);
    auto* const side = new QVBoxLayout;
    side->addWidget(m_remove);
    side->addStretch();
    row->addLayout(side);
    auto* const hint = new QListWidgetItem(tr("Click an object in the view to take its bearing."), m_list);
    hint->setFlags(Qt::ItemIsEnabled);
    m_remove->setEnabled(false);
    connect(m_remove, &QPushButton::clicked, this, &BearingList::removeChosen);
}

void BearingList::add(const Bearing& bearing, const QString& clock) {
    if (m_bearings.empty()) m_list->clear();
    m_bearings.insert(m_bearings.begin(), bearing);
    m_list->insertItem(0, textOf(bearing, clock));
    if (m_bearings.size() > kMost) {
        m_bearings.pop_back();
        delete m_list->takeItem(m_list->count() - 1);
    }
    m_remove->setEnabled(true);
    Q_EMIT changed();
}

void BearingList::removeChosen() {
    std::vector<int> rows;
    for (const QModelIndex& index : m_list->selectionModel()->selectedRows()) rows.push_back(index.row());
    if (rows.empty())
        for (int row = 0; row < m_list->count(); ++row) rows.push_back(row);
    std::sort(rows.rbegin(), rows.rend());
    for (const int row : rows) {
        m_bearings.erase(m_bearings.begin() + row);
        delete m_list->takeItem(row);
    }
    m_remove->setEnabled(!m_bearings.empty());
    Q_EMIT changed();
}

BearingOverlay::BearingOverlay(ChartWidget& chart) : QWidget(&chart), m_chart(chart) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    chart.installEventFilter(this);
    resize(chart.size());
}

void BearingOverlay::setBearings(std::vector<Bearing> bearings) {
    m_bearings = std::move(bearings);
    update();
}

bool BearingOverlay::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::Resize) resize(m_chart.size());
    return QWidget::eventFilter(object, event);
}

void BearingOverlay::paintEvent(QPaintEvent*) {
    if (m_bearings.empty()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QSizeF shown = m_chart.view().size();
    painter.setClipRect(QRectF(QPointF(), shown));
    const ChartPalette& colours = chartPalette(m_chart.colours());
    for (const Bearing& b : m_bearings) {
        const QPointF from = m_chart.view().toScreen(b.from);
        const QPointF to = m_chart.view().toScreen(b.from + kLine_m * core::unitVector(b.grid_rad));
        painter.setPen(QPen(colours.halo, 4.0));
        painter.drawLine(from, to);
        painter.setPen(QPen(colours.tool, 1.6));
        painter.drawLine(from, to);
        painter.setBrush(colours.panel);
        painter.drawEllipse(from, 3.0, 3.0);
        const double far = std::hypot(to.x() - from.x(), to.y() - from.y());
        if (far <= 0.0) continue;
        const QPointF at = from + 70.0 / far * (to - from) + QPointF(6.0, -6.0);
        drawText(painter, at, Qt::AlignLeft,
                 QStringLiteral("%1°").arg(chart::bearing(b.true_rad / core::kDegree_rad)),
                 {QFontInfo(font()).pixelSize() * 1.0, colours.tool, colours.halo, true, false});
    }
}

}  // namespace sagara::ui::console
