#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <vector>

#include "core/exercise/Snapshot.h"
#include "ui/theme/PaletteName.h"

namespace sagara::ui {

/// MODEL of the traffic: every ship of the scenario and every one added, there or not, as seen from the first
/// own ship. Bearings and courses are true.
class TrafficModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Bearing, Range, Course, Speed, ColumnCount };
    struct Row {
        std::size_t target = 0;  ///< index as in TargetView
        QString name;
        bool hostile = false;
        bool present = false;
        bool stopped = false;  ///< dead in the water, or at anchor
        core::NorthEast position;
        double heading_rad = 0.0;
        double speed_mps = 0.0;
        double bearing_rad = 0.0;
        double range_m = 0.0;
        QString doing;
    };

    explicit TrafficModel(const core::World& world, QObject* parent = nullptr)
        : QAbstractTableModel(parent), m_world(world) {}
    void setColours(PaletteName name);
    void show(const core::Snapshot& now);
    const Row* row(int index) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    Row rowOf(const core::Snapshot& now, std::size_t target) const;

    const core::World& m_world;
    PaletteName m_palette = PaletteName::Day;
    std::vector<Row> m_rows;
};

}  // namespace sagara::ui
