#include "ui/vessels/TrialsPanel.h"

#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSaveFile>
#include <QTableWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <QtConcurrent>

#include "core/base/Units.h"
#include "ui/theme/ThemeColours.h"
#include "ui/vessels/TrialPlots.h"

namespace sagara::ui {

TrialsPanel::TrialsPanel(QWidget* parent)
    : QWidget(parent),
      m_run(new QPushButton(tr("Run trials"), this)),
      m_cancel(new QPushButton(tr("Cancel"), this)),
      m_csv(new QPushButton(tr("Save as CSV…"), this)),
      m_bar(new QProgressBar(this)),
      m_note(new QLabel(this)),
      m_checks(new QTableWidget(0, 4, this)),
      m_turning(new PlotView(this)),
      m_time(new PlotView(this)),
      m_zigzag10(new PlotView(this)),
      m_zigzag20(new PlotView(this)),
      m_stopping(new PlotView(this)),
      m_timer(new QTimer(this)) {
    m_run->setObjectName(QStringLiteral("runTrials"));
    m_run->setProperty("primary", true);
    m_run->setToolTip(
        tr("Turning circles to both sides, zigzags 10/10 and 20/20, crash stop: deep calm water"));
    m_cancel->setObjectName(QStringLiteral("cancelTrials"));
    m_cancel->setToolTip(tr("Stops the trials; nothing is kept of them"));
    m_csv->setObjectName(QStringLiteral("saveCsv"));
    m_csv->setToolTip(tr("One file for each run, time series with units in the column names"));
    m_bar->setObjectName(QStringLiteral("trialsProgress"));
    m_bar->setRange(0, 1000);
    m_bar->setToolTip(tr("Share of the trials done"));
    m_checks->setObjectName(QStringLiteral("imoChecks"));
    m_checks->setHorizontalHeaderLabels({tr("IMO MSC.137(76)"), tr("Ship"), tr("Limit"), tr("Result")});
    m_checks->verticalHeader()->hide();
    m_checks->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_checks->setSelectionMode(QAbstractItemView::NoSelection);
    m_checks->setShowGrid(false);
    m_checks->setAlternatingRowColors(true);
    m_checks->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_checks->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_checks->setMinimumWidth(380);
    m_note->setWordWrap(true);
    m_note->setObjectName(QStringLiteral("trialsNote"));

    auto* const buttons = new QHBoxLayout;
    buttons->addWidget(m_run);
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_bar, 1);
    buttons->addWidget(m_csv);
    auto* const left = new QVBoxLayout;
    left->addWidget(m_checks, 1);
    left->addWidget(m_note);
    auto* const plots = new QGridLayout;
    plots->setSpacing(6);
    plots->addWidget(m_turning, 0, 0, 2, 1);
    plots->addWidget(m_time, 0, 1);
    plots->addWidget(m_stopping, 1, 1);
    plots->addWidget(m_zigzag10, 2, 0);
    plots->addWidget(m_zigzag20, 2, 1);
    for (int i = 0; i < 3; ++i) plots->setRowStretch(i, 1);
    auto* const both = new QHBoxLayout;
    both->addLayout(left, 2);
    both->addLayout(plots, 5);
    auto* const layout = new QVBoxLayout(this);
    layout->addLayout(buttons);
    layout->addLayout(both, 1);

    m_timer->setInterval(100);
    connect(m_timer, &QTimer::timeout, this, [this] {
        if (m_progress) m_bar->setValue(m_progress->permille);
    });
    connect(m_run, &QPushButton::clicked, this, &TrialsPanel::start);
    connect(m_cancel, &QPushButton::clicked, this, &TrialsPanel::cancel);
    connect(m_csv, &QPushButton::clicked, this, &TrialsPanel::saveCsv);
    connect(&m_watcher, &QFutureWatcherBase::finished, this, [this] {
        m_timer->stop();
        const bool wanted = m_progress && !m_progress->cancelled;
        m_progress.reset();
        if (wanted) m_trials = m_watcher.result();
        showTrials();
        showState();
        if (wanted) Q_EMIT finished();
    });
    showTrials();
    showState();
}

TrialsPanel::~TrialsPanel() {
    if (m_progress) m_progress->cancelled = true;
    m_watcher.disconnect(this);
    m_watcher.waitForFinished();
}

void TrialsPanel::setVessel(std::optional<core::Vessel> vessel) {
    cancel();
    m_vessel = std::move(vessel);
    m_trials.reset();
    showTrials();
    showState();
}

void TrialsPanel::setColours(PaletteName name) {
    m_colours = name;
    for (PlotView* plot : {m_turning, m_time, m_zigzag10, m_zigzag20, m_stopping}) plot->setColours(name);
    showTrials();
}

bool TrialsPanel::running() const { return m_progress && !m_progress->cancelled; }

void TrialsPanel::start() {
    if (!m_vessel || m_watcher.isRunning()) return;
    m_progress = std::make_shared<Progress>();
    m_watcher.setFuture(QtConcurrent::run([vessel = *m_vessel, progress = m_progress] {
        return core::runStandardTrials(vessel, [&](double share, const std::string&) {
            progress->permille = static_cast<int>(1000.0 * share);
            return !progress->cancelled;
        });
    }));
    m_timer->start();
    showState();
}

void TrialsPanel::cancel() {
    if (m_progress) m_progress->cancelled = true;
    showState();
}

void TrialsPanel::showState() {
    const bool on = running();
    m_run->setEnabled(m_vessel.has_value() && !on && !m_watcher.isRunning());
    m_cancel->setEnabled(on);
    m_csv->setEnabled(m_trials.has_value() && !on);
    m_bar->setVisible(on);
    if (!on) m_bar->setValue(0);
}

void TrialsPanel::showTrials() {
    const core::StandardTrials trials = m_trials.value_or(core::StandardTrials{});
    const core::ImoLimits limits =
        m_trials ? core::imoLimits(trials.zigzag10.length_m, trials.zigzag10.approach_mps)
                 : core::ImoLimits{};
    m_turning->setPlot(turningPlot(trials));
    m_time->setPlot(turningTimePlot(trials.turnStarboard));
    m_zigzag10->setPlot(
        zigzagPlot(trials.zigzag10, limits.zigzag10First_deg, limits.zigzag10Second_deg, 10.0));
    m_zigzag20->setPlot(zigzagPlot(trials.zigzag20, limits.zigzag20First_deg, 0.0, 20.0));
    m_stopping->setPlot(stoppingPlot(trials.stop));
    m_checks->setRowCount(0);
    if (!m_trials) {
        m_note->setText(m_vessel ? tr("Not run yet. The trials take a few seconds.")
                                 : tr("Choose a vessel on the left."));
        return;
    }
    const ThemeColours& c = themeColours(m_colours);
    for (const core::ImoCheck& check : core::imoChecks(trials)) {
        const int row = m_checks->rowCount();
        m_checks->insertRow(row);
        const QString unit = check.unit == "L" ? tr("L") : tr("°");
        const auto put = [&](int column, const QString& text) {
            auto* const item = new QTableWidgetItem(text);
            if (column > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            m_checks->setItem(row, column, item);
            return item;
        };
        put(0, QString::fromStdString(check.criterion));
        put(1,
            check.value ? QStringLiteral("%1 %2").arg(*check.value, 0, 'f', 1).arg(unit) : tr("not reached"));
        put(2, QStringLiteral("%1 %2").arg(check.limit, 0, 'f', 1).arg(unit));
        QTableWidgetItem* const result = put(3, check.met() ? tr("✓ met") : tr("✗ not met"));
        result->setForeground(check.met() ? c.text : c.alarm);
        QFont bold = font();
        bold.setBold(!check.met());
        result->setFont(bold);
    }
    const core::Trial& turn = trials.turnStarboard;
    QString note = tr("From %1 kn, L = %2 m between perpendiculars.")
                       .arg(turn.approach_mps / core::kKnot_mps, 0, 'f', 1)
                       .arg(turn.length_m, 0, 'f', 1);
    if (turn.measure("steady_drift_deg"))
        note += tr(" Steady turn: %1 % of the speed, drift %2°, diameter %3 L.")
                    .arg(100.0 * *turn.measure("steady_speed_ratio"), 0, 'f', 0)
                    .arg(*turn.measure("steady_drift_deg"), 0, 'f', 0)
                    .arg(*turn.measure("steady_diameter_over_L"), 0, 'f', 1);
    if (turn.length_m < core::kImoBindsFrom_m)
        note +=
            tr(" The standards bind ships of 100 m and more; she is shorter, so they are for information.");
    m_note->setText(note);
}

void TrialsPanel::saveCsv() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the time series"));
    if (folder.isEmpty()) return;
    const std::pair<const char*, const core::Trial*> runs[] = {{"turn-starboard", &m_trials->turnStarboard},
                                                               {"turn-port", &m_trials->turnPort},
                                                               {"zigzag-10", &m_trials->zigzag10},
                                                               {"zigzag-20", &m_trials->zigzag20},
                                                               {"stopping", &m_trials->stop}};
    for (const auto& [name, trial] : runs) {
        QSaveFile file(QStringLiteral("%1/%2-%3.csv")
                           .arg(folder, QString::fromStdString(m_vessel->id), QString::fromLatin1(name)));
        const std::string text = core::trialCsv(*trial);
        if (file.open(QIODevice::WriteOnly) &&
            file.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size()) &&
            file.commit())
            continue;
        QMessageBox::warning(this, tr("Save as CSV"),
                             tr("%1 cannot be written: %2").arg(file.fileName(), file.errorString()));
        return;
    }
}

}  // namespace sagara::ui
