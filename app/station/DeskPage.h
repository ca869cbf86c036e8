#pragma once

#include "app/station/Frame.h"
#include "app/station/StationRun.h"
#include "app/station/StationWall.h"

namespace sagara::ui {
class TrainerDesk;
}

namespace sagara::station {

/// The trainer's desk with the run it is the desk of, and the run's wall.
class DeskPage final : public ui::Page {
    Q_OBJECT

public:
    DeskPage(Frame& frame, std::unique_ptr<StationRun> run);
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
    void openConsole();

    Frame& m_frame;
    std::unique_ptr<StationRun> m_run;
    std::unique_ptr<StationWall> m_wall;
    ui::TrainerDesk* m_desk = nullptr;
    std::unique_ptr<QWidget> m_console;  ///< the trainee's, on another monitor
};

}  // namespace sagara::station
