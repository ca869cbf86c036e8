#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "ui/run/ExerciseRun.h"
#include "ui/theme/PaletteName.h"
#include "ui/trainer/TrafficModel.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableView;

namespace sagara::ui {

class ChartWidget;

/// The traffic and what the trainer does with it: add a ship where he clicks on the chart, order course and
/// speed or a route of clicks, drag one elsewhere, stop her, let her go on, take her away and bring her back.
class TrafficBoard final : public QWidget {
    Q_OBJECT

public:
    /// `chart`: on which is clicked and dragged; outlives the board.
    TrafficBoard(ExerciseRun& run, ChartWidget& chart, QWidget* parent = nullptr);
    void setColours(PaletteName name);
    void refresh(const core::Snapshot& now);
    /// The ship of that index (as in TargetView) becomes the chosen one.
    void choose(std::size_t target);
    std::optional<std::size_t> chosen() const;

private:
    enum class Doing { Nothing, Adding, Routing, Moving };
    void addTable();
    QWidget* orderBox();
    void begin(Doing doing);
    void clickedAt(core::NorthEast position);
    void askForShip(core::NorthEast position);
    void endRoute();
    void steer();
    void giveAction(core::TargetAction action);
    void showHandles();
    void update();
    const TrafficModel::Row* chosenRow() const;

    ExerciseRun& m_run;
    ChartWidget& m_chart;
    TrafficModel* m_model;
    QTableView* m_table;
    QLabel* m_hint;
    QPushButton *m_add, *m_move, *m_route, *m_steer, *m_stop, *m_there;
    QDoubleSpinBox *m_heading, *m_speed;
    Doing m_doing = Doing::Nothing;
    std::vector<core::NorthEast> m_points;
};

}  // namespace sagara::ui
