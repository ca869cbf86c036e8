#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "ui/debrief/Marks.h"
#include "ui/theme/PaletteName.h"

namespace sagara::ui {

class ChartWidget;

/// A line on the chart with ticks and times at whole minutes of the run.
struct OverlayTrack {
    struct Point {
        double time_s = 0.0;
        core::NorthEast position;
    };
    std::vector<Point> points;
    std::size_t colour = 0;  ///< in ThemeColours::series
    bool ticks = false;
    bool faint = false;
};

/// Where a second ship is: the same ship in the run that is compared.
struct OverlayShip {
    core::NorthEast position;
    double heading_rad = 0.0;
    double length_m = 0.0;
    double beam_m = 0.0;
    QString name;
    std::size_t colour = 1;
};

/// Over a chart, without taking its mouse: the whole of a track, what happened along it, a second ship.
class ChartOverlay final : public QWidget {
    Q_OBJECT

public:
    explicit ChartOverlay(ChartWidget& chart);

    void setColours(PaletteName name);
    void setTracks(std::vector<OverlayTrack> tracks);
    void setMarks(const std::vector<DebriefMark>& marks);
    void setShip(std::optional<OverlayShip> ship);
    /// The mark under a point of the chart; null: none.
    const DebriefMark* markAt(QPointF at) const;
    QPointF placeOf(const DebriefMark& mark) const;

Q_SIGNALS:
    /// A click on the sign of a mark.
    void markPicked(core::SimTime time);

protected:
    void paintEvent(QPaintEvent*) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void drawTrack(QPainter& p, const OverlayTrack& track) const;
    void drawShip(QPainter& p) const;

    ChartWidget& m_chart;
    PaletteName m_colours = PaletteName::Day;
    std::vector<OverlayTrack> m_tracks;
    std::vector<DebriefMark> m_marks;
    std::optional<OverlayShip> m_ship;
    QPointF m_pressedAt;
};

/// Track points of one ship, a second apart.
std::vector<OverlayTrack::Point> overlayPoints(const std::vector<core::TrackSample>& track);

}  // namespace sagara::ui
