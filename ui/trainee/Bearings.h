#pragma once

#include <QWidget>
#include <vector>

#include "core/base/Planar.h"
#include "core/base/SimTime.h"
#include "ui/theme/PaletteName.h"

class QListWidget;
class QPushButton;

namespace sagara::ui {
class ChartWidget;
}

namespace sagara::ui::console {

/// A visual bearing as it was taken.
struct Bearing {
    core::NorthEast from;
    double grid_rad = 0.0;  ///< frame N
    double true_rad = 0.0;
    double relative_rad = 0.0;  ///< from the bow, starboard positive
    core::SimTime time;
};

/// The bearings taken in the view, the newest first; those that are chosen or all are drawn on the chart.
class BearingList final : public QWidget {
    Q_OBJECT

public:
    static constexpr std::size_t kMost = 12;
    explicit BearingList(QWidget* parent = nullptr);
    /// `clock`: the local time it was taken at.
    void add(const Bearing& bearing, const QString& clock);
    const std::vector<Bearing>& bearings() const { return m_bearings; }

Q_SIGNALS:
    void changed();

private:
    void removeChosen();

    std::vector<Bearing> m_bearings;
    QListWidget* m_list;
    QPushButton* m_remove;
};

/// Lines of position over a chart: lies on it, takes no mouse.
class BearingOverlay final : public QWidget {
    Q_OBJECT

public:
    explicit BearingOverlay(ChartWidget& chart);
    void setBearings(std::vector<Bearing> bearings);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void paintEvent(QPaintEvent*) override;

private:
    ChartWidget& m_chart;
    std::vector<Bearing> m_bearings;
};

}  // namespace sagara::ui::console
