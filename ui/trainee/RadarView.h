#pragma once

#include <QImage>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/bridge/Radar.h"
#include "ui/theme/ThemeColours.h"

namespace sagara::ui::console {

/// The plan position indicator: echoes with afterglow, rings, heading line, electronic bearing line and
/// variable range marker. Directions are of frame N and made true by the convergence where they are written.
class RadarView final : public QWidget {
    Q_OBJECT

public:
    enum class Up { Head, North, Course };

    explicit RadarView(QWidget* parent = nullptr);
    void setColours(PaletteName name);
    /// The picture is kept by the scanner and read when it is painted.
    void setPicture(const core::RadarPicture* picture);
    /// Own ship's directions and the azimuth the antenna has just passed.
    void setOwnShip(double heading_rad, std::optional<double> course_rad, double convergence_rad,
                    std::size_t sweptTo);
    void setUp(Up up);
    Up up() const { return m_up; }
    void setRings(bool on);
    void setHeadingLine(bool on);
    void setGain(double gain);  ///< 0 to 1
    void setBearingLine(std::optional<double> bearing_rad);
    void setRangeMarker(std::optional<double> range_m);
    std::optional<double> bearingLine() const { return m_ebl_rad; }
    std::optional<double> rangeMarker() const { return m_vrm_m; }

    /// A place of the screen as bearing (frame N) and range.
    struct Polar {
        double bearing_rad = 0.0;
        double range_m = 0.0;
    };
    Polar polarAt(QPointF p) const;
    QPointF placeOf(const Polar& polar) const;
    double headingUp_rad() const;  ///< what is up, clockwise from north of frame N

    QSize minimumSizeHint() const override { return {220, 220}; }

Q_SIGNALS:
    void cursorMoved(std::optional<sagara::ui::console::RadarView::Polar> at);
    void rangeStepped(int steps);  ///< by the mouse wheel; positive: longer
    void toolsMoved();             ///< bearing line or range marker, by hand

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void leaveEvent(QEvent*) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    QPointF centre() const;
    double margin_px() const;
    double radius_px() const;
    void makeTable(int side);
    void drawEchoes(QPainter& painter);
    void drawScale(QPainter& painter) const;
    void drawTools(QPainter& painter) const;
    void moveTools(const Polar& to);

    const core::RadarPicture* m_picture = nullptr;
    PaletteName m_palette = PaletteName::Day;
    Up m_up = Up::Head;
    bool m_rings = true;
    bool m_headingLine = true;
    double m_gain = 0.75;
    double m_heading_rad = 0.0;
    std::optional<double> m_course_rad;
    double m_convergence_rad = 0.0;
    std::size_t m_sweptTo = 0;
    std::optional<double> m_ebl_rad, m_vrm_m;
    bool m_dragsLine = false, m_dragsMarker = false;
    QImage m_image;
    /// For every pixel of the image azimuth from up and cell, packed; kOutside where the screen ends.
    std::vector<std::uint32_t> m_table;
};

/// Distance of the rings of a range scale: six of them, four on 0.5 M and less.
double ringStep_m(double range_m);

}  // namespace sagara::ui::console
