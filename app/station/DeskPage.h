#pragma once

#include <QPointer>

#include "app/station/StationRun.h"
#include "app/station/StationWall.h"
#include "ui/theme/Page.h"
#include "ui/trainee/TraineeConsole.h"

class QLabel;

namespace sagara::ui {
class TraineeConsole;
class TrainerDesk;
}  // namespace sagara::ui

namespace sagara::station {

class Station;

/// The trainer's desk with the run it is the desk of, and the run's wall.
class DeskPage final : public ui::Page {
    Q_OBJECT

public:
    /// `chart`: of the run's area; null: it is made here.
    DeskPage(Station& station, std::unique_ptr<StationRun> run,
             std::shared_ptr<const ui::PreparedChart> chart = nullptr);
    ~DeskPage() override;

    void setColours(ui::PaletteName name) override;
    bool mayLeave() override;
    QString helpTopic() const override { return QStringLiteral("desk"); }

    StationRun& run() { return *m_run; }
    StationWall& wall() { return *m_wall; }
    ui::TrainerDesk* desk() const { return m_desk; }
    /// Ends the run and shows its result in place of the desk.
    void endRun();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void makeDesk();
    void goBack(std::int64_t second);
    void showGoingBack(bool on);
    void openConsole();

    Station& m_station;
    std::unique_ptr<StationRun> m_run;
    std::shared_ptr<const ui::PreparedChart> m_chart;
    std::unique_ptr<StationWall> m_wall;
    ui::TrainerDesk* m_desk = nullptr;
    QWidget* m_goingBack;  ///< shown while that is worked out
    QLabel* m_goingBackTo;
    int m_ways = 0;                          ///< counts them: one called off is not gone
    QPointer<ui::TraineeConsole> m_console;  ///< on another monitor where there is one
};

}  // namespace sagara::station
