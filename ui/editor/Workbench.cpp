#include "ui/editor/Workbench.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/editor/DraftMarks.h"
#include "ui/editor/DryRunPanel.h"
#include "ui/editor/FieldText.h"
#include "ui/editor/ObjectForm.h"
#include "ui/editor/ProblemList.h"
#include "ui/editor/SectionAids.h"
#include "ui/theme/Theme.h"
#include "ui/widgets/ChartWidget.h"

namespace sagara::ui::editor {
namespace {

constexpr int kSections_px = 150, kForm_px = 440;
constexpr double kSnap_px = 10.0;  ///< so near a named place the place itself is meant
constexpr int kLaidOut_ms = 60;    ///< the form of a row just chosen has its place then

QLabel* heading(const QString& text, QWidget* parent) {
    auto* const label = new QLabel(text, parent);
    QFont font = label->font();
    font.setPointSizeF(1.3 * font.pointSizeF());
    font.setBold(true);
    label->setFont(font);
    return label;
}

}  // namespace

Workbench::Workbench(EditorContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_validator(context),
      m_sections(scenarioSections()),
      m_list(new QListWidget(this)),
      m_chart(new ChartWidget(this)),
      m_problems(new ProblemList(m_sections, this)),
      m_stack(new QStackedWidget(this)),
      m_dryRun(new DryRunPanel(context, this)) {
    m_list->setObjectName(QStringLiteral("sections"));
    m_list->setToolTip(words("Pages of the scenario"));
    m_list->setFixedWidth(kSections_px);
    m_list->setIconSize({22, 22});
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_stack->setMinimumWidth(kForm_px);
    addPages();
    auto* const splitter = new QSplitter(this);
    splitter->addWidget(chartSide());
    splitter->addWidget(m_stack);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 2);
    splitter->setChildrenCollapsible(false);
    auto* const layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_list);
    layout->addWidget(splitter, 1);

    connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
        m_stack->setCurrentIndex(row);
        loadPage();
        refreshChart();
    });
    connect(&context.draft(), &ScenarioDraft::changed, this, [this] {
        m_problems->setChecking();
        loadPage();
        refreshChart();
    });
    connect(&context, &EditorContext::selectionChanged, this, &Workbench::refreshChart);
    connect(&context, &EditorContext::areaChanged, this, &Workbench::areaRead);
    connect(&m_validator, &Validator::checked, this, &Workbench::showProblems);
    connect(m_problems, &ProblemList::chosen, this, &Workbench::reveal);
    connect(m_chart, &ChartWidget::handleDragged, this, &Workbench::dragged);
    connect(m_chart, &ChartWidget::handleMoved, this, [this](int handle, core::NorthEast to) {
        dragged(handle, to);
        m_context.draft().endGoing();
        refreshChart();
        const std::string& path = m_picture.handles[static_cast<std::size_t>(handle)].path;
        if (section() == "marks") page().form->reveal(parentOf(path));
    });
    connect(m_chart, &ChartWidget::clicked, this, &Workbench::clicked);
    connect(m_chart, &ChartWidget::picked, this, [this](const ChartPick& pick) {
        if (m_add->isChecked()) return;
        if (pick.kind == ChartPick::Kind::OwnShip) reveal(join("ownShips", pick.index));
        if (pick.kind == ChartPick::Kind::Target) reveal(join("traffic", pick.index));
        if (pick.kind == ChartPick::Kind::Waypoint) reveal(join("route.waypoints", pick.index));
        if (pick.kind == ChartPick::Kind::SceneMark) reveal(join("marks", pick.index));
    });
    connect(m_dryRun, &DryRunPanel::trackChanged, this, &Workbench::refreshChart);
    connect(m_dryRun, &DryRunPanel::placeChosen, m_chart, &ChartWidget::centreOn);
    m_list->setCurrentRow(0);
}

void Workbench::addPages() {
    const auto page = [this](const QString& title, const QString& about, QWidget* above, QWidget* inside) {
        auto* const body = new QWidget(this);
        auto* const layout = new QVBoxLayout(body);
        layout->setContentsMargins(8, 2, 12, 8);
        layout->addWidget(heading(title, body));
        auto* const words = new QLabel(about, body);
        words->setWordWrap(true);
        layout->addWidget(words);
        if (above) layout->addWidget(above);
        layout->addWidget(inside);
        layout->addStretch(1);
        auto* const area = new QScrollArea(this);
        area->setWidget(body);
        area->setWidgetResizable(true);
        area->setFrameShape(QFrame::NoFrame);
        area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        m_stack->addWidget(area);
        return area;
    };
    for (const Section& s : m_sections) {
        auto* const form = new ObjectForm(m_context, s.fields, {}, this);
        QWidget* above = nullptr;
        if (s.id == "weather") above = new WeatherAid(m_context, this);
        if (s.id == "levels") above = new LevelsAid(m_context, this);
        if (s.id == "marks") above = m_marks = new MarksAid(m_context, this);
        m_pages.push_back({page(s.title, s.about, above, form), form});
        m_list->addItem(s.title);
    }
    m_pages.push_back(
        {page(words("Dry run"), words("Before trainees sail it: can it be done, and what is the score?"),
              nullptr, m_dryRun),
         nullptr});
    m_list->addItem(words("Dry run"));
}

QWidget* Workbench::chartSide() {
    auto* const side = new QWidget(this);
    auto* const bar = new QWidget(side);
    addChartTools(*bar);
    auto* const layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(bar);
    layout->addWidget(m_chart, 1);
    layout->addWidget(m_problems);
    m_chart->setObjectName(QStringLiteral("chart"));
    return side;
}

void Workbench::addChartTools(QWidget& bar) {
    auto* const row = new QHBoxLayout(&bar);
    row->setContentsMargins(0, 0, 0, 0);
    const auto button = [&](const char* name, const QString& text, const QString& tip) {
        auto* const b = new QToolButton(&bar);
        b->setObjectName(QString::fromLatin1(name));
        b->setText(text);
        b->setToolTip(tip);
        row->addWidget(b);
        return b;
    };
    connect(button("whole-area", words("Whole area"), words("Show all of the chart")), &QToolButton::clicked,
            m_chart, &ChartWidget::fitArea);
    connect(button("show-scenario", words("Scenario"), words("Show the route and the own ships")),
            &QToolButton::clicked, this, &Workbench::fitToDraft);
    m_add = button("chart-add", words("Add by click"),
                   words("Route: each click is a waypoint after the chosen one. Marks: a mark of the chosen "
                         "kind. Traffic: "
                         "the next point of the chosen ship. Own ship: puts her there"));
    m_add->setCheckable(true);
    connect(m_add, &QToolButton::toggled, m_marks, &MarksAid::setAdding);
    connect(m_marks, &MarksAid::kindChosen, m_add, [this] { m_add->setChecked(true); });
    auto* const range =
        button("chart-range", words("Range and bearing"), words("Drag a line on the chart (Esc ends)"));
    range->setCheckable(true);
    connect(range, &QToolButton::toggled, this, [this](bool on) {
        m_chart->chooseTool(on ? ChartTools::Tool::RangeBearing : ChartTools::Tool::None);
    });
    connect(m_chart, &ChartWidget::toolChanged, range,
            [range](ChartTools::Tool tool) { range->setChecked(tool == ChartTools::Tool::RangeBearing); });
    row->addStretch(1);
}

void Workbench::setColours(PaletteName colours) {
    m_chart->setColours(colours);
    m_problems->setColours(colours);
    for (std::size_t i = 0; i < m_sections.size(); ++i)
        m_list->item(static_cast<int>(i))->setIcon(themedIcon(m_sections[i].icon, colours));
    m_list->item(m_list->count() - 1)->setIcon(themedIcon(QStringLiteral("media-play-google"), colours));
}

const std::string& Workbench::section() const {
    const auto row = static_cast<std::size_t>(std::max(0, m_list->currentRow()));
    return row < m_sections.size() ? m_sections[row].id : m_dryRunId;
}

const Workbench::Page& Workbench::page() const {
    return m_pages[static_cast<std::size_t>(m_list->currentRow())];
}

void Workbench::begin() {
    m_list->setCurrentRow(0);
    m_fitWanted = true;
    areaRead();
    loadPage();
}

void Workbench::openSection(const std::string& id) {
    for (std::size_t i = 0; i < m_sections.size(); ++i)
        if (m_sections[i].id == id) m_list->setCurrentRow(static_cast<int>(i));
    if (id == m_dryRunId) m_list->setCurrentRow(m_list->count() - 1);
}

void Workbench::reveal(const std::string& path) {
    for (std::size_t i = 0; i < m_sections.size(); ++i) {
        if (!m_sections[i].holds(path)) continue;
        m_list->setCurrentRow(static_cast<int>(i));
        FieldEditor* const field = m_pages[i].form->reveal(path);
        if (!field) return;
        field->focusEntry();
        QScrollArea* const area = m_pages[i].area;
        QTimer::singleShot(kLaidOut_ms, field, [area, field] { area->ensureWidgetVisible(field, 0, 40); });
        return;
    }
}

void Workbench::loadPage() {
    const auto row = static_cast<std::size_t>(std::max(0, m_list->currentRow()));
    const bool addable =
        section() == "route" || section() == "marks" || section() == "traffic" || section() == "ownShips";
    m_add->setEnabled(addable);
    if (!addable) m_add->setChecked(false);
    if (row >= m_pages.size() || !m_pages[row].form) return;
    m_pages[row].form->load();
    m_pages[row].form->showProblems(m_validator.problems());
}

void Workbench::showProblems() {
    m_problems->show(m_validator.problems());
    loadPage();
}

// the chart

void Workbench::areaRead() {
    m_chart->setChart(m_context.chart());
    refreshChart();
    if (m_context.chart() && std::exchange(m_fitWanted, false)) fitToDraft();
}

void Workbench::fitToDraft() {
    chart::Extent extent;
    for (const auto& w : m_picture.scene.route.waypoints) extent.include(w.position);
    for (const auto& ship : m_picture.scene.ownShips) extent.include(ship.position);
    if (extent.empty) return m_chart->fitArea();
    const double least_m =
        extent.height_m() + extent.width_m() < 500.0 ? 1500.0 : 300.0;  // a ship alone: her surroundings
    const core::NorthEast margin{0.12 * extent.height_m() + least_m, 0.12 * extent.width_m() + least_m};
    extent.include(extent.southWest - margin);
    extent.include(extent.northEast + margin);
    m_chart->fitTo(extent);
}

void Workbench::refreshChart() {
    m_picture = pictureOf(m_context, section());
    ChartScene scene = m_picture.scene;
    if (scene.route.waypoints.size() > 1) scene.path = core::RoutePath(scene.route);
    if (section() == m_dryRunId && !m_dryRun->run().result().track.points.empty())
        scene.tracks.push_back(m_dryRun->run().result().track);
    const auto start = core::parseUtc(textAt(m_context.draft().document(), "startUtc"));
    if (start && m_context.area())
        scene.clockAtZero_s =
            static_cast<double>((start->unix_s + 60 * m_context.area()->utcOffset_min) % 86400);
    const std::vector<ChartHandle> handles = std::exchange(scene.handles, m_chart->scene().handles);
    m_chart->setScene(std::move(scene));
    m_chart->setHandles(handles);  // leaves the one in the hand where it is
    if (m_context.area())
        m_context.setNewPlace(
            m_context.area()->frame.toGeo(m_chart->view().toChart(m_chart->view().middle())));
}

void Workbench::dragged(int handle, core::NorthEast to) {
    if (!m_context.area() || handle < 0 || static_cast<std::size_t>(handle) >= m_picture.handles.size())
        return;
    const DraftHandle what = m_picture.handles[static_cast<std::size_t>(handle)];
    m_context.draft().edit(
        words("drag on the chart"),
        [&](Json& document) {
            drag(document, *m_context.area(), what, to, m_chart->view().toMetres(kSnap_px));
        },
        QStringLiteral("drag ") + QString::fromStdString(what.path));
}

void Workbench::clicked(core::NorthEast place) {
    if (!m_add->isChecked() || !m_context.area()) return;
    const core::GeoPoint geo = m_context.area()->frame.toGeo(place);
    if (section() == "route") addWaypoint(geo);
    if (section() == "traffic") addTargetPoint(geo);
    if (section() == "marks") addMark(geo);
    if (section() != "ownShips") return;
    const std::string ship = m_context.selected().starts_with("ownShips[")
                                 ? m_context.selected().substr(0, m_context.selected().find(']') + 1)
                                 : std::string("ownShips[0]");
    const bool alongside = m_context.draft().at(join(ship, "berth")) != nullptr;
    const DraftHandle handle{
        alongside ? DraftHandle::Kind::ShipAtBerth : DraftHandle::Kind::Ship, ship, {}, {}, {}, false};
    m_context.draft().edit(words("own ship placed"),
                           [&](Json& document) { drag(document, *m_context.area(), handle, place, 0.0); });
}

/// After the chosen one, with the limits of the one before it.
void Workbench::addWaypoint(core::GeoPoint place) {
    const std::string path = "route.waypoints";
    const std::size_t count = sizeAt(m_context.draft().document(), path);
    const bool chosen = m_context.selected().starts_with(path + "[");
    const std::size_t at = count == 0 ? 0
                           : chosen   ? std::min(indexOf(m_context.selected()) + 1, count)
                                      : count;
    m_context.draft().edit(words("new waypoint"), [&](Json& document) {
        if (count == 0) {
            put(document, "route.name", textAt(document, "route.name", words("Route").toStdString()));
            put(document, path, Json::array());
        }
        Json all = *editor::find(document, path);
        Json row = at > 0 ? all[at - 1] : Json::object();
        row["name"] = words("Waypoint %1").arg(count + 1).toStdString();
        row["at"] = positionJson(place);
        all.insert(all.begin() + static_cast<std::ptrdiff_t>(at), std::move(row));
        put(document, path, std::move(all));
    });
    page().form->reveal(join(path, at));
}

void Workbench::addTargetPoint(core::GeoPoint place) {
    const std::string& selected = m_context.selected();
    if (!selected.starts_with("traffic["))
        return m_context.say(words("Add a ship first, then click where she goes."));
    const std::string path = join(selected.substr(0, selected.find(']') + 1), "route");
    m_context.draft().edit(words("new point"), [&](Json& document) {
        Json all = sizeAt(document, path) == 0 ? Json::array() : *editor::find(document, path);
        Json row{{"at", positionJson(place)}};
        if (!all.empty()) row["speed_kn"] = numberAt(all.back(), "speed_kn", 5.0);
        all.push_back(std::move(row));
        put(document, path, std::move(all));
    });
}

void Workbench::addMark(core::GeoPoint place) {
    const std::size_t count = sizeAt(m_context.draft().document(), "marks");
    m_context.draft().edit(words("new mark"), [&](Json& document) {
        Json all = count == 0 ? Json::array() : *editor::find(document, "marks");
        all.push_back(newMark(document, m_marks->kind(), place));
        put(document, "marks", std::move(all));
    });
    page().form->reveal(join("marks", count));
}

}  // namespace sagara::ui::editor
