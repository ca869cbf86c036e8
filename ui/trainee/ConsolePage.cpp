#include "ui/trainee/ConsolePage.h"

#include <QMessageBox>
#include <QVBoxLayout>

namespace sagara::ui {

ConsolePage::ConsolePage(ExerciseRun& run, render::Stage* stage, const ConsoleOptions& options,
                         QWidget* parent)
    : Page(parent), m_run(run), m_console(new TraineeConsole(run, stage, options, this)) {
    setWindowTitle(m_console->windowTitle());
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_console);
}

bool ConsolePage::mayLeave() {
    if (!m_run.running() || m_run.over()) return true;
    return QMessageBox::question(this, windowTitle(), tr("The exercise is running. Leave the bridge?")) ==
           QMessageBox::Yes;
}

}  // namespace sagara::ui
