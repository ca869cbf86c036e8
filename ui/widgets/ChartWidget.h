#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ui/widgets/ChartCamera.h"
#include "ui/widgets/ChartFurniture.h"
#include "ui/widgets/ChartPick.h"
#include "ui/widgets/ChartPicture.h"
#include "ui/widgets/ChartTools.h"
#include "ui/widgets/RouteShape.h"

namespace sagara::ui {

/// VIEW: the chart of an area with what happens in it. Everything shown is given by value, in SI and frame N;
/// the widget asks nobody and keeps no clock. What is worked out lives in ChartCamera (where the view is),
/// ChartTools (what is measured) and pickOnChart (what lies where), which need no window.
///
/// Mouse: drag pans, wheel zooms about the cursor, click picks; with a tool chosen the left button measures
/// and the middle one pans. Keys: arrows pan, + and - zoom, Home goes to the own ship and follows her, Esc
/// cancels.
class ChartWidget final : public QWidget {
    Q_OBJECT
public:
    explicit ChartWidget(QWidget* parent = nullptr);

    /// Shows an area; all of it when it is another than before. Null: none.
    void setChart(std::shared_ptr<const PreparedChart> chart);
    void setColours(PaletteName name);
    PaletteName colours() const { return m_look.palette; }
    void setLayers(ChartLayers shown);
    void setLayerShown(ChartLayer layer, bool shown);
    ChartLayers layers() const { return m_look.shown; }
    /// Size of plain words in logical pixels; symbols go with it. 12 unless set.
    void setLetterSize(double letter_px);
    /// Distance of logical pixels on the screen, for the natural scale. 96 to the inch unless set.
    void setPixelPitch(double pixel_mm);

    /// All that moves, or one part of it. The first own ship is followed and measured from.
    void setScene(ChartScene scene);
    void setOwnShips(std::vector<ChartShip> ships);
    void setTargets(std::vector<ChartShip> ships);
    void setTracks(std::vector<ChartTrack> tracks);
    void extendTrack(std::size_t track, const ChartTrackPoint& point);
    void setPredictions(std::vector<ChartPrediction> predictions);
    void setRoute(const core::Route& route);
    void setZones(std::vector<ChartZone> zones);
    void setAnchors(std::vector<ChartAnchor> anchors);
    /// `NPerPx`: of the arrows; 0: as suits the forces.
    void setForces(std::vector<ShownForce> forces, double NPerPx = 0.0);
    void setHandles(std::vector<ChartHandle> handles);
    void setClearance(double clearance_m);
    void setVectorLength(double minutes);
    const ChartScene& scene() const { return m_scene; }
    const std::shared_ptr<const PreparedChart>& chart() const { return m_look.chart; }

    const ChartTransform& view() const { return m_camera.transform(); }
    bool following() const { return m_camera.following(); }
    ChartCamera::Orientation orientation() const { return m_camera.orientation(); }
    ChartTools::Tool tool() const { return m_tools.tool(); }
    const ChartTools& tools() const { return m_tools; }
    ChartPick pickAt(QPointF at) const;
    /// What the strip below the chart says now.
    ChartReadout readout() const;
    /// How often the area was drawn anew, for tests and benchmarks.
    int picturesMade() const { return m_picture.made(); }

    QSize sizeHint() const override { return {960, 640}; }
    QSize minimumSizeHint() const override { return {320, 240}; }

public Q_SLOTS:
    void fitArea();
    void fitTo(const sagara::chart::Extent& extent);
    void centreOn(core::NorthEast p);
    void zoomIn();
    void zoomOut();
    void follow(bool on);
    void setHeadUp(bool on);
    void chooseTool(sagara::ui::ChartTools::Tool tool);

Q_SIGNALS:
    void cursorMoved(core::NorthEast position);
    void picked(const sagara::ui::ChartPick& pick);
    /// With every picked: where.
    void clicked(core::NorthEast position);
    /// While a handle is dragged, and once when it is let go. A drag that is cancelled gives handleDragged
    /// with the old position.
    void handleDragged(int id, core::NorthEast position);
    void handleMoved(int id, core::NorthEast position);
    void followingChanged(bool following);
    void toolChanged(sagara::ui::ChartTools::Tool tool);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    enum class Gesture { None, Press, Pan, Tool, Handle };

    QRectF chartArea() const;
    QRectF stripArea() const;
    const core::LocalFrame& frame() const;
    std::optional<core::NorthEast> ownShip() const;
    std::optional<std::size_t> handleAt(QPointF at) const;
    void shipsChanged();
    /// After the view was changed by somebody: the chart is no longer fitted; tells when following ended or
    /// began.
    void afterMoving(bool followedBefore);
    void beginTool(QPointF at);
    double directionNear(QPointF at) const;
    void dragHandle(core::NorthEast to);
    bool cancel();
    QString tipAt(QPointF at) const;
    void showCursor();

    ChartPicture::Look m_look;
    ChartCamera m_camera;
    ChartTools m_tools;
    ChartScene m_scene;
    ChartPicture m_picture;
    RouteShape m_routeShape;  ///< of the scene's route at the scale of the last repaint; step 0: to be made
    bool m_whole = true;  ///< shows all of the area, and does so when resized, until somebody moves the chart
    Gesture m_gesture = Gesture::None;
    QPointF m_pressedAt;
    QPointF m_lastAt;
    std::optional<core::NorthEast> m_cursor;
    std::size_t m_handle = 0;
    core::NorthEast m_handleFrom;
};

}  // namespace sagara::ui
