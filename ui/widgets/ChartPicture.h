#pragma once

#include <QImage>
#include <memory>
#include <vector>

#include "ui/widgets/ChartPalette.h"
#include "ui/widgets/ChartScene.h"
#include "ui/widgets/ChartTransform.h"
#include "ui/widgets/PreparedChart.h"

namespace sagara::ui {

/// A picture of the area, kept until the view needs another. It is larger than the screen, so that small
/// moves of the chart only shift it.
class ChartPicture {
public:
    /// All it depends on.
    struct Look {
        std::shared_ptr<const PreparedChart> chart;
        PaletteName palette = PaletteName::Day;
        ChartLayers shown = kAllChartLayers;
        double letter_px = 12.0;
        double pixel_mm = 0.2646;
        double devicePixelRatio = 1.0;
        friend bool operator==(const Look&, const Look&) = default;
    };

    /// Makes a new picture when the one there does not serve.
    void show(const Look& look, const ChartTransform& view);
    /// Draws it where the view has it; after show.
    void draw(QPainter& painter, const ChartTransform& view) const;
    /// Where marks and names are on the screen; after show.
    std::vector<QRectF> names(const ChartTransform& view) const;
    /// How many were made since the beginning.
    int made() const { return m_made; }

private:
    bool serves(const Look& look, const ChartTransform& view) const;
    QPointF offset(const ChartTransform& view) const;

    Look m_look;
    ChartTransform m_view{{1.0, 1.0}, {}, 1.0};  ///< of the picture, margins included
    QImage m_image;
    std::vector<QRectF> m_names;  ///< in the picture
    int m_made = 0;
};

}  // namespace sagara::ui
