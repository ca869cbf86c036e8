#pragma once

#include "ui/theme/Page.h"
#include "ui/trainee/TraineeConsole.h"

namespace sagara::ui {

/// The trainee's console as a page of the station.
class ConsolePage final : public Page {
    Q_OBJECT

public:
    ConsolePage(ExerciseRun& run, render::Stage* stage, const ConsoleOptions& options,
                QWidget* parent = nullptr);

    TraineeConsole& console() { return *m_console; }
    void setColours(PaletteName name) override { m_console->setColours(name); }
    /// Asks while the exercise runs.
    bool mayLeave() override;
    QString helpTopic() const override { return QStringLiteral("console"); }

private:
    ExerciseRun& m_run;
    TraineeConsole* m_console;
};

}  // namespace sagara::ui
