#include "ui/trainer/TrafficBoard.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableView>
#include <QVBoxLayout>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "ui/trainer/AddTargetDialog.h"
#include "ui/widgets/ChartTexts.h"
#include "ui/widgets/ChartWidget.h"

namespace sagara::ui {
namespace {

constexpr int kMoveHandle = 9000, kPointHandles = 9100;
constexpr std::size_t kPlanTrack = 1;  ///< of the chart: the route that is being clicked

QPushButton* button(const QString& text, const QString& name, const QString& tip, QWidget* parent,
                    bool checkable = false) {
    auto* const made = new QPushButton(text, parent);
    made->setObjectName(name);
    made->setToolTip(tip);
    made->setCheckable(checkable);
    return made;
}

}  // namespace

TrafficBoard::TrafficBoard(ExerciseRun& run, ChartWidget& chart, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_chart(chart),
      m_model(new TrafficModel(*run.world(), this)),
      m_table(new QTableView(this)),
      m_hint(new QLabel(this)),
      m_add(button(tr("Add a ship…"), QStringLiteral("target-add"),
                   tr("Then click on the chart where she is to be"), this, true)) {
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    addTable();
    layout->addWidget(m_table, 1);
    layout->addWidget(m_add);
    layout->addWidget(orderBox());
    m_hint->setObjectName(QStringLiteral("target-hint"));
    m_hint->setWordWrap(true);
    m_hint->setMinimumHeight(2 * m_hint->fontMetrics().height() + 4);
    m_hint->setAlignment(Qt::AlignTop);
    layout->addWidget(m_hint);
    connect(m_add, &QPushButton::clicked, this,
            [this](bool on) { begin(on ? Doing::Adding : Doing::Nothing); });
    connect(&chart, &ChartWidget::clicked, this, &TrafficBoard::clickedAt);
    connect(&chart, &ChartWidget::picked, this, [this](const ChartPick& pick) {
        if (m_doing == Doing::Nothing && pick.kind == ChartPick::Kind::Target &&
            pick.index < m_chart.scene().targets.size())
            choose(static_cast<std::size_t>(m_chart.scene().targets[pick.index].id));
    });
    connect(&chart, &ChartWidget::handleMoved, this, [this](int id, core::NorthEast to) {
        const TrafficModel::Row* const row = chosenRow();
        if (id != kMoveHandle || row == nullptr) return;
        m_run.give(0, core::MoveTargetOrder{static_cast<std::uint32_t>(row->target), to, row->heading_rad});
        begin(Doing::Nothing);
    });
    refresh(*run.latest());
    if (m_model->rowCount() > 0) m_table->selectRow(0);
    update();
}

void TrafficBoard::addTable() {
    m_table->setObjectName(QStringLiteral("targets"));
    m_table->setModel(m_model);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 10);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setTabKeyNavigation(false);
    m_table->setMinimumHeight(150);
    QHeaderView* const head = m_table->horizontalHeader();
    head->setHighlightSections(false);
    head->setMinimumSectionSize(30);
    head->setSectionResizeMode(QHeaderView::ResizeToContents);
    head->setSectionResizeMode(TrafficModel::Name, QHeaderView::Stretch);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
        if (m_doing != Doing::Adding) begin(Doing::Nothing);
        if (const TrafficModel::Row* const row = chosenRow(); row != nullptr && row->present) {
            const double convergence_rad = m_run.world()->area.frame.convergence_rad(row->position);
            m_heading->setValue(
                std::fmod((row->heading_rad - convergence_rad) / core::kDegree_rad + 720.0, 360.0));
            m_speed->setValue(row->speed_mps / core::kKnot_mps);
        }
        update();
    });
}

QWidget* TrafficBoard::orderBox() {
    auto* const box = new QGroupBox(tr("The chosen ship"), this);
    const auto spin = [&](double most, int decimals, const QString& unit, const QString& name) {
        auto* const made = new QDoubleSpinBox(box);
        made->setRange(0.0, most);
        made->setDecimals(decimals);
        made->setSuffix(QLatin1Char(' ') + unit);
        made->setObjectName(name);
        made->setToolTip(tr("0 to %1 %2").arg(most).arg(unit));
        return made;
    };
    m_heading = spin(359.0, 0, tr("°T"), QStringLiteral("target-heading"));
    m_heading->setWrapping(true);
    m_speed = spin(60.0, 1, tr("kn"), QStringLiteral("target-speed"));
    m_steer = button(tr("Order"), QStringLiteral("target-steer"),
                     tr("She turns to this heading and keeps it at this speed"), box);
    m_route = button(tr("Route by clicks"), QStringLiteral("target-route"),
                     tr("Click her points on the chart, then press this again; she goes at the speed above"),
                     box, true);
    m_move = button(tr("Put elsewhere"), QStringLiteral("target-move"), tr("Drag the square on the chart"),
                    box, true);
    m_stop = button(tr("Stop"), QStringLiteral("target-stop"), {}, box);
    m_there = button(tr("Remove"), QStringLiteral("target-there"), {}, box);
    auto* const grid = new QGridLayout(box);
    grid->setSpacing(4);
    grid->addWidget(m_heading, 0, 0);
    grid->addWidget(m_speed, 0, 1);
    grid->addWidget(m_steer, 0, 2);
    auto* const more = new QHBoxLayout;
    more->setSpacing(4);
    more->addWidget(m_route);
    more->addWidget(m_move);
    grid->addLayout(more, 1, 0, 1, 3);
    auto* const last = new QHBoxLayout;
    last->setSpacing(4);
    last->addWidget(m_stop);
    last->addWidget(m_there);
    grid->addLayout(last, 2, 0, 1, 3);
    connect(m_steer, &QPushButton::clicked, this, &TrafficBoard::steer);
    connect(m_route, &QPushButton::clicked, this,
            [this](bool on) { on ? begin(Doing::Routing) : endRoute(); });
    connect(m_move, &QPushButton::clicked, this,
            [this](bool on) { begin(on ? Doing::Moving : Doing::Nothing); });
    connect(m_stop, &QPushButton::clicked, this, [this] {
        giveAction(m_stop->property("resumes").toBool() ? core::TargetAction::Resume
                                                        : core::TargetAction::Stop);
    });
    connect(m_there, &QPushButton::clicked, this, [this] {
        const TrafficModel::Row* const row = chosenRow();
        if (row != nullptr)
            giveAction(row->present ? core::TargetAction::Remove : core::TargetAction::Appear);
    });
    return box;
}

void TrafficBoard::setColours(PaletteName name) { m_model->setColours(name); }

const TrafficModel::Row* TrafficBoard::chosenRow() const {
    return m_model->row(m_table->currentIndex().row());
}

std::optional<std::size_t> TrafficBoard::chosen() const {
    const TrafficModel::Row* const row = chosenRow();
    return row == nullptr ? std::nullopt : std::optional(row->target);
}

void TrafficBoard::choose(std::size_t target) { m_table->selectRow(static_cast<int>(target)); }

void TrafficBoard::begin(Doing doing) {
    m_doing = doing;
    m_points.clear();
    showHandles();
    update();
}

void TrafficBoard::showHandles() {
    std::vector<ChartHandle> handles;
    std::vector<ChartTrackPoint> plan;
    const TrafficModel::Row* const row = chosenRow();
    if (m_doing == Doing::Moving && row != nullptr)
        handles.push_back({kMoveHandle, row->position, tr("Drag %1 to another place").arg(row->name)});
    if (m_doing == Doing::Routing && row != nullptr) {
        plan.push_back({0.0, row->position});
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            handles.push_back({kPointHandles + static_cast<int>(i), m_points[i], tr("Point %1").arg(i + 1)});
            plan.push_back({0.0, m_points[i]});
        }
    }
    m_chart.setHandles(std::move(handles));
    std::vector<ChartTrack> tracks = m_chart.scene().tracks;
    if (tracks.size() <= kPlanTrack && plan.empty()) return;
    tracks.resize(kPlanTrack + 1);
    tracks[kPlanTrack] = {std::move(plan), false};
    m_chart.setTracks(std::move(tracks));
}

void TrafficBoard::clickedAt(core::NorthEast position) {
    if (m_doing == Doing::Adding) askForShip(position);
    if (m_doing != Doing::Routing || m_points.size() >= core::kLongestTargetRoute) return;
    m_points.push_back(position);
    showHandles();
    update();
}

void TrafficBoard::askForShip(core::NorthEast position) {
    begin(Doing::Nothing);
    const core::LocalFrame& frame = m_run.world()->area.frame;
    auto* const dialog =
        new AddTargetDialog(positionText(frame, position), m_run.latest()->added.size() + 1, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, position, &frame] {
        m_run.give(0, dialog->order(position, frame.convergence_rad(position)));
    });
    dialog->open();
}

void TrafficBoard::endRoute() {
    const TrafficModel::Row* const row = chosenRow();
    if (row != nullptr && !m_points.empty()) {
        core::RouteTargetOrder order;
        order.target = static_cast<std::uint32_t>(row->target);
        const double speed_mps = m_speed->value() * core::kKnot_mps;
        for (const core::NorthEast point : m_points) order.points.push_back({point, speed_mps});
        m_run.give(0, std::move(order));
    }
    begin(Doing::Nothing);
}

void TrafficBoard::steer() {
    const TrafficModel::Row* const row = chosenRow();
    if (row == nullptr || !row->present) return;
    const double grid_rad =
        m_heading->value() * core::kDegree_rad + m_run.world()->area.frame.convergence_rad(row->position);
    m_run.give(0, core::SteerTargetOrder{static_cast<std::uint32_t>(row->target), grid_rad,
                                         m_speed->value() * core::kKnot_mps});
}

void TrafficBoard::giveAction(core::TargetAction action) {
    if (const auto target = chosen())
        m_run.give(0, core::TargetOrder{static_cast<std::uint32_t>(*target), action, 0.0});
}

void TrafficBoard::refresh(const core::Snapshot& now) {
    m_model->show(now);
    update();
}

void TrafficBoard::update() {
    const TrafficModel::Row* const row = chosenRow();
    const bool open = !m_run.over(), there = open && row != nullptr && row->present;
    const bool full = m_run.latest()->added.size() >= core::kMostAddedTargets;
    m_add->setEnabled(open && !full);
    m_add->setChecked(m_doing == Doing::Adding);
    m_route->setEnabled(there);
    m_route->setChecked(m_doing == Doing::Routing);
    m_route->setText(m_doing == Doing::Routing ? tr("Send her (%1)").arg(m_points.size())
                                               : tr("Route by clicks"));
    m_move->setEnabled(there);
    m_move->setChecked(m_doing == Doing::Moving);
    m_steer->setEnabled(there);
    m_heading->setEnabled(there);
    m_speed->setEnabled(there);
    const bool stopped = row != nullptr && row->stopped;
    m_stop->setEnabled(there);
    m_stop->setProperty("resumes", stopped);
    m_stop->setText(stopped ? tr("Go on") : tr("Stop"));
    m_stop->setToolTip(stopped ? tr("She does again what she did by herself, or what the scenario says")
                               : tr("She takes all way off"));
    m_there->setEnabled(open && row != nullptr);
    m_there->setText(row != nullptr && !row->present ? tr("Bring her") : tr("Take away"));
    m_there->setToolTip(row != nullptr && !row->present ? tr("She appears where she begins")
                                                        : tr("She is gone at once"));
    QString hint;
    if (m_doing == Doing::Adding)
        hint = tr("Click on the chart where she is to be.");
    else if (m_doing == Doing::Routing)
        hint = m_points.empty() ? tr("Click her points on the chart, in order.")
                                : tr("Click more points, or press “Send her”.");
    else if (m_doing == Doing::Moving)
        hint = tr("Drag the square on the chart.");
    else if (full)
        hint = tr("%1 ships are added; there cannot be more.").arg(core::kMostAddedTargets);
    else if (m_model->rowCount() == 0)
        hint = tr("No traffic yet. “Add a ship…” makes one.");
    else if (row != nullptr && row->present)
        hint = row->hostile ? tr("%1, a threat: %2.").arg(row->name, row->doing)
                            : tr("%1: %2.").arg(row->name, row->doing);
    if (m_hint->text() != hint) m_hint->setText(hint);
}

}  // namespace sagara::ui
