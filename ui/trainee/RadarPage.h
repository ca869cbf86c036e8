#pragma once

#include <QWidget>

#include "ui/trainee/RadarScanner.h"
#include "ui/trainee/RadarView.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QSlider;

namespace sagara::ui::console {

/// The radar: its screen and what an operator sets.
class RadarPage final : public QWidget {
    Q_OBJECT

public:
    RadarPage(const core::World& world, std::size_t ship, QWidget* parent = nullptr);
    void setColours(PaletteName name);
    /// Turns the antenna on; `time` is the picture's.
    void advance(core::SimTime time, const core::Snapshot& now);
    RadarView& view() { return *m_view; }
    double range_m() const { return m_scanner.picture().range_m; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void setRange(int index);
    void showTools();
    void showCursor(std::optional<RadarView::Polar> at);
    QString bearingText(double bearing_rad) const;
    void addControls(QWidget* panel);

    const core::World& m_world;
    std::size_t m_ship;
    RadarScanner m_scanner;
    RadarView* m_view;
    QComboBox* m_range;
    QLabel *m_cursor, *m_lineText, *m_markerText;
    double m_heading_rad = 0.0, m_convergence_rad = 0.0;
};

}  // namespace sagara::ui::console
