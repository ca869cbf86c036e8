#pragma once

#include <QImage>

#include "core/bridge/Sonar.h"
#include "ui/trainee/Gauge.h"

namespace sagara::ui::console {

/// The sector ahead of the ship: bottom coloured by the water over it, hulls in white, range rings; below it
/// the profile of the bottom right ahead.
class SonarView final : public Gauge {
    Q_OBJECT

public:
    explicit SonarView(QWidget* parent = nullptr);
    /// `draught_m`: what is shallower than it and half as much again is red.
    void setPicture(core::SonarPicture picture, double draught_m);
    const core::SonarPicture& picture() const { return m_picture; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QColor bottomColour(double depth_m) const;
    void drawSector(QPainter& painter, const QRectF& box);
    void drawProfile(QPainter& painter, const QRectF& box) const;

    core::SonarPicture m_picture;
    double m_draught_m = 0.0;
};

}  // namespace sagara::ui::console
