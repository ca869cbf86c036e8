#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/vessel/Hull.h"
#include "ui/theme/PaletteName.h"

namespace sagara::ui {

/// Sections of a hull from its stations, or where it has none, from its particulars: waterline and sectional
/// areas as powers that give the waterplane and block coefficients.
std::vector<core::HullStation> sectionsOf(const core::Hull& hull);
/// Half breadth of a section at a depth below the waterline: (b/2) (1 - (z/t)^n), n from its area.
double halfBreadth_m(const core::HullStation& station, double depth_m);

/// Body plan (aft to the left, forward to the right), waterplane and profile of a hull below the waterline.
class SectionsView final : public QWidget {
    Q_OBJECT

public:
    explicit SectionsView(QWidget* parent = nullptr);
    void setHull(std::optional<core::Hull> hull);
    void setColours(PaletteName name);
    QSize sizeHint() const override { return {420, 280}; }
    QSize minimumSizeHint() const override { return {240, 170}; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    std::optional<core::Hull> m_hull;
    std::vector<core::HullStation> m_sections;
    PaletteName m_colours = PaletteName::Day;
};

}  // namespace sagara::ui
