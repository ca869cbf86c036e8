#include "ui/trainer/TrafficModel.h"

#include <QColor>
#include <algorithm>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "ui/chart/Format.h"
#include "ui/theme/ThemeColours.h"
#include "ui/widgets/Measure.h"

namespace sagara::ui {
namespace {

QString degrees(double rad) { return chart::bearing(rad / core::kDegree_rad) + QStringLiteral("°"); }

QString activityText(core::Activity activity) {
    switch (activity) {
        case core::Activity::UnderWay:
            return TrafficModel::tr("under way");
        case core::Activity::Anchored:
            return TrafficModel::tr("at anchor");
        case core::Activity::Fishing:
            return TrafficModel::tr("fishing");
        case core::Activity::Trawling:
            return TrafficModel::tr("trawling");
        case core::Activity::Towing:
            return TrafficModel::tr("towing");
        case core::Activity::NotUnderCommand:
            return TrafficModel::tr("not under command");
        case core::Activity::Restricted:
            return TrafficModel::tr("restricted in her ability to manoeuvre");
        case core::Activity::Moored:
            return TrafficModel::tr("moored");
        case core::Activity::Sailing:
            return TrafficModel::tr("sailing");
    }
    return {};
}

}  // namespace

void TrafficModel::setColours(PaletteName name) {
    m_palette = name;
    if (!m_rows.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1), {Qt::ForegroundRole});
}

TrafficModel::Row TrafficModel::rowOf(const core::Snapshot& now, std::size_t target) const {
    const core::TargetLayout& layout = core::targetLayout(m_world, now, target);
    Row row;
    row.target = target;
    row.name = QString::fromStdString(layout.name);
    row.hostile = layout.behaviour == core::TargetBehaviour::Hostile;
    const auto seen = std::find_if(now.targets.begin(), now.targets.end(),
                                   [&](const core::TargetView& t) { return t.index == target; });
    if (seen == now.targets.end()) {
        row.doing = tr("not there");
        return row;
    }
    row.present = true;
    row.position = seen->position;
    row.heading_rad = seen->heading_rad;
    row.speed_mps = seen->speed_mps;
    // Who is stopped under way is not under command (core::activityNow).
    row.stopped = seen->activity == core::Activity::NotUnderCommand || seen->speed_mps < 0.2;
    row.doing = activityText(seen->activity);
    if (now.ships.empty()) return row;
    const RangeBearing from = measure(m_world.area.frame, now.ships[0].motion.position(), seen->position);
    row.bearing_rad = from.bearing_rad;
    row.range_m = from.distance_m;
    return row;
}

void TrafficModel::show(const core::Snapshot& now) {
    const std::size_t count = m_world.targets.size() + now.added.size();
    if (count > m_rows.size()) {
        beginInsertRows({}, rowCount(), static_cast<int>(count) - 1);
        for (std::size_t i = m_rows.size(); i < count; ++i) m_rows.push_back(rowOf(now, i));
        endInsertRows();
    } else if (count < m_rows.size()) {  // somebody went back
        beginRemoveRows({}, static_cast<int>(count), rowCount() - 1);
        m_rows.resize(count);
        endRemoveRows();
    }
    for (std::size_t i = 0; i < count; ++i) m_rows[i] = rowOf(now, i);
    if (count > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

const TrafficModel::Row* TrafficModel::row(int index) const {
    const auto i = static_cast<std::size_t>(index);
    return index >= 0 && i < m_rows.size() ? &m_rows[i] : nullptr;
}

int TrafficModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}
int TrafficModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QVariant TrafficModel::data(const QModelIndex& index, int role) const {
    const Row* const r = row(index.row());
    if (r == nullptr) return {};
    const ThemeColours& c = themeColours(m_palette);
    if (role == Qt::ForegroundRole) {
        if (!r->present) return c.quietText;
        return r->hostile && index.column() == Name ? QVariant(c.port) : QVariant();
    }
    if (role == Qt::TextAlignmentRole)
        return QVariant(index.column() == Name ? Qt::AlignLeft | Qt::AlignVCenter
                                               : Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole)
        return r->hostile ? tr("%1: threat, %2").arg(r->name, r->doing) : tr("%1: %2").arg(r->name, r->doing);
    if (role != Qt::DisplayRole) return {};
    if (index.column() == Name) return r->hostile ? QStringLiteral("⚠ ") + r->name : r->name;
    if (!r->present) return QStringLiteral("–");
    switch (index.column()) {
        case Bearing:
            return degrees(r->bearing_rad);
        case Range:
            return chart::number(r->range_m / core::kNauticalMile_m, 2);
        case Course:
            return degrees(trueDirection_rad(m_world.area.frame, r->position, r->heading_rad));
        case Speed:
            return chart::number(r->speed_mps / core::kKnot_mps, 1);
        default:
            return {};
    }
}

QVariant TrafficModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    static const std::pair<const char*, const char*> kHeads[] = {
        {QT_TR_NOOP("Ship"), QT_TR_NOOP("Threats with a sign")},
        {QT_TR_NOOP("Brg °T"), QT_TR_NOOP("True bearing from the own ship")},
        {QT_TR_NOOP("Rng M"), QT_TR_NOOP("Distance from the own ship in nautical miles")},
        {QT_TR_NOOP("Hdg °T"), QT_TR_NOOP("Her true heading")},
        {QT_TR_NOOP("Kn"), QT_TR_NOOP("Her speed through the water in knots")}};
    if (section < 0 || section >= ColumnCount) return {};
    if (role == Qt::DisplayRole) return tr(kHeads[section].first);
    if (role == Qt::ToolTipRole) return tr(kHeads[section].second);
    return {};
}

}  // namespace sagara::ui
