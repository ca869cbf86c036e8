#include "app/station/SailPage.h"

#include <QMessageBox>
#include <QVBoxLayout>

#include "app/station/BridgeLink.h"
#include "app/station/Station.h"

namespace sagara::station {

SailPage::SailPage(Station& station, std::unique_ptr<StationRun> run, ui::ConsoleOptions options, Ended ended)
    : m_station(station), m_run(std::move(run)), m_ended(std::move(ended)) {
    setWindowTitle(QString::fromStdString(m_run->world()->scenarioName));
    options.colours = station.colours();
    options.keys = false;  // BridgeLink takes them, as they are mapped
    m_console = new ui::TraineeConsole(*m_run, station.stageFor(m_run->world()), options, this);
    new BridgeLink(station.input(), station.sound(), *m_console, *m_run);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_console);
    setFocusProxy(m_console);
    connect(m_console, &ui::TraineeConsole::endWanted, this, [this] {
        if (mayLeave()) Q_EMIT leaveWanted();
    });
}

SailPage::~SailPage() { delete m_console; }  // before the run it looks at

/// A run that has begun is not just left: it ends, and its result takes the place of this page.
bool SailPage::mayLeave() {
    if (m_run->latest()->tick == 0) return true;
    if (!m_run->over() &&
        QMessageBox::question(this, tr("Sagara"), tr("End the run? It is graded as it stands.")) !=
            QMessageBox::Yes)
        return false;
    end();
    return false;
}

void SailPage::end() {
    const run::RunSummary summary = m_run->end();
    m_ended(*m_run, summary);
}

}  // namespace sagara::station
