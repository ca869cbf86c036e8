// The parts of the debriefing and where they lie. What they do: DebriefDesk.cpp, WhatIf.cpp.
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/debrief/ComparePanel.h"
#include "ui/debrief/DebriefDesk.h"
#include "ui/debrief/PlotStack.h"
#include "ui/debrief/ScorePanel.h"
#include "ui/debrief/TimeAxis.h"
#include "ui/debrief/Timeline.h"
#include "ui/debrief/TransportBar.h"
#include "ui/debrief/ViewsPanel.h"
#include "ui/run/RunTexts.h"
#include "ui/trainer/Instruments.h"
#include "ui/widgets/ChartWidget.h"

namespace sagara::ui {
namespace {

constexpr int kFrame_ms = 50, kBeat_ms = 100;
constexpr int kLeftLeast_px = 335;  ///< the widest row of the instruments

QScrollArea* scrolled(QWidget* inside) {
    auto* const area = new QScrollArea;
    area->setWidget(inside);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    return area;
}

QToolButton* toolButton(const QString& text, const QString& tip, const QString& name, QWidget* parent) {
    auto* const button = new QToolButton(parent);
    button->setText(text);
    button->setToolTip(tip);
    button->setObjectName(name);
    button->setAutoRaise(true);
    return button;
}

QString titleOf(const Replay& replay) {
    const core::RecordingHeader& h = replay.header();
    const QString trainee =
        h.trainee.empty() ? DebriefDesk::tr("nobody named") : QString::fromStdString(h.trainee);
    const core::Utc started{h.startedUnix_s};
    return DebriefDesk::tr("<b>%1</b> · %2 · level %3 · sailed %4 UTC")
        .arg(QString::fromStdString(replay.world()->scenarioName).toHtmlEscaped(), trainee.toHtmlEscaped())
        .arg(h.level)
        .arg(QString::fromStdString(core::formatUtc(started))
                 .left(16)
                 .replace(QLatin1Char('T'), QLatin1Char(' ')));
}

}  // namespace

DebriefDesk::DebriefDesk(const DebriefPorts& ports, OpenedRecording opened, QWidget* parent)
    : QWidget(parent),
      m_ports(ports),
      m_replay(std::move(opened.replay)),
      m_axis(new TimeAxis(this)),
      m_title(new QLabel(titleOf(*m_replay), this)),
      m_remark(new QLabel(this)),
      m_notice(new QLabel(this)),
      m_chart(new ChartWidget(this)),
      m_overlay(new ChartOverlay(*m_chart)),
      m_left(new QStackedWidget(this)),
      m_score(new ScorePanel(this)),
      m_compare(new ComparePanel(this)),
      m_views(new ViewsPanel(this)),
      m_transport(new TransportBar(this)),
      m_timeline(new Timeline(*m_axis, this)),
      m_plots(new PlotStack(*m_axis, this)),
      m_noteBar(new QWidget(this)),
      m_noteText(new QLineEdit(m_noteBar)),
      m_across(new QSplitter(Qt::Horizontal, this)),
      m_down(new QSplitter(Qt::Vertical, this)),
      m_frames(new QTimer(this)),
      m_beat(new QTimer(this)),
      m_plotData(std::move(opened.plots)) {
    const core::World& world = *m_replay->world();
    m_chart->setObjectName(QStringLiteral("chart"));
    m_chart->setChart(std::move(opened.chart));
    m_chart->setRoute(world.route);
    m_axis->setWhole(m_replay->begin(), m_replay->end());
    m_axis->setCursor(m_replay->begin());
    m_plots->setData(m_plotData);

    auto* const tabs = new QTabWidget(m_left);
    tabs->setObjectName(QStringLiteral("debrief-tabs"));
    tabs->addTab(m_score, tr("Score"));
    if (!world.ships.empty()) {
        m_instruments = new Instruments(world, 0, this);
        tabs->addTab(scrolled(m_instruments), tr("Instruments"));
    }
    m_left->addWidget(tabs);
    m_left->addWidget(m_compare);
    m_left->setMinimumWidth(kLeftLeast_px);

    m_across->addWidget(m_left);
    m_across->addWidget(chartPanel());
    m_across->addWidget(m_views);
    m_across->setStretchFactor(1, 1);
    m_across->setChildrenCollapsible(false);
    m_down->addWidget(m_across);
    m_down->addWidget(lowerPanel());
    m_down->setStretchFactor(0, 1);
    m_down->setChildrenCollapsible(false);

    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(header());
    for (QLabel* label : {m_remark, m_notice}) {
        label->setWordWrap(true);
        label->setContentsMargins(8, 4, 8, 4);
        label->hide();
        layout->addWidget(label);
    }
    m_remark->setObjectName(QStringLiteral("remark"));
    m_notice->setObjectName(QStringLiteral("notice"));
    layout->addWidget(m_down, 1);

    connect(m_axis, &TimeAxis::picked, this, &DebriefDesk::goTo);
    connect(m_overlay, &ChartOverlay::markPicked, this, &DebriefDesk::goTo);
    connect(m_score, &ScorePanel::picked, this, &DebriefDesk::goTo);
    connect(m_compare, &ComparePanel::picked, this, &DebriefDesk::goTo);
    connect(m_compare, &ComparePanel::sailOnWanted, this, &DebriefDesk::sailOn);
    connect(m_compare, &ComparePanel::closeWanted, this, &DebriefDesk::endBranch);
    connect(m_timeline, &Timeline::stepWanted, this, &DebriefDesk::step);
    connect(m_transport, &TransportBar::stepWanted, this, &DebriefDesk::step);
    connect(m_transport, &TransportBar::markWanted, this, &DebriefDesk::goToMark);
    connect(m_transport, &TransportBar::playToggled, this, &DebriefDesk::togglePlay);
    connect(m_transport, &TransportBar::sailWanted, this, &DebriefDesk::sailFromHere);
    connect(m_transport, &TransportBar::noteWanted, this, [this] {
        m_replay->pause();
        m_noteAt = shown();
        m_noteText->setPlaceholderText(tr("Note at %1, at most 200 letters").arg(elapsed(m_noteAt)));
        m_noteBar->show();
        m_noteText->setFocus();
    });
    m_transport->setReplay(*m_replay);
    if (!m_ports.branch) findChild<QPushButton*>(QStringLiteral("sail-from-here"))->hide();
    if (!m_ports.addNote) findChild<QPushButton*>(QStringLiteral("add-note"))->hide();
    m_score->setResult(m_replay->result());
    m_way = overlayPoints(m_replay->track());
    readMarks();
    refreshTracks();
    connect(m_frames, &QTimer::timeout, this, &DebriefDesk::drawViews);
    connect(m_beat, &QTimer::timeout, this, &DebriefDesk::refresh);
    m_frames->setInterval(kFrame_ms);
    m_beat->setInterval(kBeat_ms);
    setFocusProxy(m_timeline);
    refresh();
}

QWidget* DebriefDesk::header() {
    auto* const bar = new QWidget(this);
    auto* const layout = new QHBoxLayout(bar);
    layout->setContentsMargins(4, 0, 4, 0);
    m_title->setObjectName(QStringLiteral("title"));
    m_title->setTextFormat(Qt::RichText);
    layout->addWidget(m_title, 1);
    auto* const plots = new QPushButton(tr("Plots"), bar);
    plots->setObjectName(QStringLiteral("plots-menu"));
    plots->setToolTip(tr("Choose what is plotted"));
    auto* const menu = new QMenu(plots);
    fillPlotMenu(*menu);
    plots->setMenu(menu);
    layout->addWidget(plots);
    if (m_ports.openResult) {
        auto* const result = new QPushButton(tr("Result and report"), bar);
        result->setObjectName(QStringLiteral("open-result"));
        result->setToolTip(tr("Comment, sign-off and printed report of this run"));
        connect(result, &QPushButton::clicked, this, [this] { m_ports.openResult(); });
        layout->addWidget(result);
    }
    return bar;
}

void DebriefDesk::fillPlotMenu(QMenu& menu) {
    const auto& shown = m_plots->shown();
    for (int i = 0; i < kPlotKinds; ++i) {
        const auto kind = static_cast<PlotKind>(i);
        QAction* const action = menu.addAction(plotTitle(kind));
        action->setObjectName(QStringLiteral("plot-%1").arg(i));
        action->setCheckable(true);
        action->setChecked(std::find(shown.begin(), shown.end(), kind) != shown.end());
        connect(action, &QAction::toggled, this, [this, kind](bool on) {
            std::vector<PlotKind> kinds;
            for (int k = 0; k < kPlotKinds; ++k) {
                const auto each = static_cast<PlotKind>(k);
                const auto& now = m_plots->shown();
                const bool was = std::find(now.begin(), now.end(), each) != now.end();
                if (each == kind ? on : was) kinds.push_back(each);
            }
            m_plots->setShown(kinds);
            m_plots->setMinimumHeight(m_plots->minimumSizeHint().height());
        });
        connect(action, &QAction::triggered, this, &DebriefDesk::plotsChosen);
    }
}

QString DebriefDesk::plotsShown() const {
    QStringList numbers;
    for (const PlotKind kind : m_plots->shown()) numbers += QString::number(static_cast<int>(kind));
    return numbers.join(QLatin1Char(','));
}

void DebriefDesk::showPlots(const QString& kept) {
    m_plotsGiven = true;
    const QStringList numbers = kept.split(QLatin1Char(','));
    for (int i = 0; i < kPlotKinds; ++i)
        findChild<QAction*>(QStringLiteral("plot-%1").arg(i))
            ->setChecked(numbers.contains(QString::number(i)));
}

QWidget* DebriefDesk::chartPanel() {
    auto* const panel = new QWidget(this);
    auto* const layout = new QVBoxLayout(panel);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* const bar = new QHBoxLayout;
    bar->setSpacing(2);
    auto* const whole =
        toolButton(tr("Whole run"), tr("Show all of the ship's way"), QStringLiteral("fit-run"), panel);
    connect(whole, &QToolButton::clicked, this, &DebriefDesk::fitRun);
    auto* const follow = toolButton(tr("Follow ship"), tr("Keep the ship in the middle (Home)"),
                                    QStringLiteral("follow"), panel);
    follow->setCheckable(true);
    connect(follow, &QToolButton::toggled, m_chart, &ChartWidget::follow);
    connect(m_chart, &ChartWidget::followingChanged, follow, &QToolButton::setChecked);
    auto* const headUp = toolButton(tr("Head up"), tr("The ship's heading is up, not north"),
                                    QStringLiteral("head-up"), panel);
    headUp->setCheckable(true);
    connect(headUp, &QToolButton::toggled, m_chart, &ChartWidget::setHeadUp);
    auto* const range = toolButton(tr("Range and bearing"), tr("Drag a line on the chart (Esc ends)"),
                                   QStringLiteral("range-bearing"), panel);
    range->setCheckable(true);
    connect(range, &QToolButton::toggled, this, [this](bool on) {
        m_chart->chooseTool(on ? ChartTools::Tool::RangeBearing : ChartTools::Tool::None);
    });
    connect(m_chart, &ChartWidget::toolChanged, range,
            [range](ChartTools::Tool tool) { range->setChecked(tool == ChartTools::Tool::RangeBearing); });
    for (QToolButton* button : {whole, follow, headUp, range}) bar->addWidget(button);
    bar->addStretch(1);
    layout->addLayout(bar);
    layout->addWidget(m_chart, 1);
    return panel;
}

QWidget* DebriefDesk::lowerPanel() {
    auto* const panel = new QWidget(this);
    auto* const layout = new QVBoxLayout(panel);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_transport);
    auto* const note = new QHBoxLayout(m_noteBar);
    note->setContentsMargins(6, 0, 6, 0);
    m_noteText->setObjectName(QStringLiteral("note-text"));
    m_noteText->setMaxLength(200);
    m_noteText->setToolTip(tr("What is to be remembered of this moment (Enter keeps it, Esc drops it)"));
    auto* const keep = new QPushButton(tr("Keep"), m_noteBar);
    keep->setObjectName(QStringLiteral("note-keep"));
    auto* const drop = new QPushButton(tr("Cancel"), m_noteBar);
    note->addWidget(m_noteText, 1);
    note->addWidget(keep);
    note->addWidget(drop);
    connect(m_noteText, &QLineEdit::returnPressed, this, [this] { addNote(true); });
    connect(keep, &QPushButton::clicked, this, [this] { addNote(true); });
    connect(drop, &QPushButton::clicked, this, [this] { addNote(false); });
    m_noteBar->hide();
    layout->addWidget(m_noteBar);
    QScrollArea* const plots = scrolled(m_plots);
    // The timeline is as wide as the plots beside their scroll bar, so that their moments lie below its own.
    auto* const times = new QHBoxLayout;
    times->setSpacing(0);
    times->addWidget(m_timeline, 1);
    times->addSpacing(plots->verticalScrollBar()->sizeHint().width());
    layout->addLayout(times);
    plots->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    plots->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    plots->setMinimumHeight(90);
    m_plots->setMinimumHeight(m_plots->minimumSizeHint().height());
    layout->addWidget(plots, 1);
    return panel;
}

}  // namespace sagara::ui
