#include "ui/editor/EditorContext.h"

#include <QFutureWatcher>
#include <QtConcurrent/QtConcurrentRun>
#include <algorithm>
#include <set>

namespace sagara::ui::editor {
namespace {

constexpr double kSafety_m = 5.0;

using Texts = std::map<std::pair<core::DocumentKind, std::string>, std::shared_ptr<const std::string>>;

class TextsSource final : public core::DocumentSource {
public:
    TextsSource(Texts texts, std::set<std::string> pictures, std::shared_ptr<core::SeaHulls> hulls)
        : m_texts(std::move(texts)), m_pictures(std::move(pictures)), m_hulls(std::move(hulls)) {}
    std::shared_ptr<core::SeaHulls> hulls() const override { return m_hulls; }
    std::optional<std::string> find(core::DocumentKind kind, const std::string& id) const override {
        if (kind == core::DocumentKind::Picture)
            return m_pictures.contains(id) ? std::optional(std::string()) : std::nullopt;
        const auto it = m_texts.find({kind, id});
        return it == m_texts.end() || !it->second ? std::nullopt : std::optional(*it->second);
    }

private:
    Texts m_texts;
    std::set<std::string> m_pictures;
    std::shared_ptr<core::SeaHulls> m_hulls;
};

struct ReadArea {
    std::shared_ptr<const core::Area> area;
    std::shared_ptr<const PreparedChart> chart;
};

ReadArea readAreaText(const std::string& id, const std::shared_ptr<const std::string>& text) {
    auto area = core::loadArea(id, *text);
    if (!area) return {};
    auto shared = std::make_shared<const core::Area>(std::move(area).value());
    return {shared, prepareChart(shared, kSafety_m)};
}

std::string named(const std::string& id, const std::string& name) { return name.empty() ? id : name; }

std::vector<Option> idsIn(const Json& document, const std::string& path, const std::string& nameKey) {
    std::vector<Option> all;
    for (std::size_t i = 0; i < sizeAt(document, path); ++i) {
        const std::string row = join(path, i), id = textAt(document, join(row, "id"));
        const std::string name = nameKey.empty() ? id : named(id, textAt(document, join(row, nameKey)));
        if (!id.empty()) all.push_back({id, QString::fromStdString(name)});
    }
    return all;
}

/// Path of the own ship that a path of the document lies in or names.
std::string shipPath(const Json& document, const std::string& path) {
    if (path.starts_with("ownShips[")) return path.substr(0, path.find(']') + 1);
    const std::string id = textAt(document, join(parentOf(path), "ship"));
    for (std::size_t i = 0; i < sizeAt(document, "ownShips"); ++i) {
        const std::string ship = join("ownShips", i);
        if (!id.empty() && textAt(document, join(ship, "id")) == id) return ship;
    }
    return join("ownShips", std::size_t{0});
}

}  // namespace

EditorContext::EditorContext(EditorPort& port, ScenarioDraft& draft, QObject* parent)
    : QObject(parent), m_port(port), m_draft(draft) {
    connect(&draft, &ScenarioDraft::changed, this, &EditorContext::readArea);
}

void EditorContext::setColours(PaletteName colours) {
    m_colours = colours;
    Q_EMIT coloursChanged();
}

void EditorContext::select(const std::string& row) {
    if (row == m_selected) return;
    m_selected = row;
    Q_EMIT selectionChanged();
}

std::shared_ptr<const std::string> EditorContext::textOf(core::DocumentKind kind,
                                                         const std::string& id) const {
    auto& text = m_texts[{kind, id}];
    if (!text) {
        if (auto found = m_port.text(kind, id)) text = std::make_shared<const std::string>(std::move(*found));
    }
    return text;
}

void EditorContext::readArea() {
    const std::string id = textAt(m_draft.document(), "area");
    if (id == m_areaId) return;
    m_areaId = id;
    m_area.reset();
    m_chart.reset();
    const auto text = textOf(core::DocumentKind::Area, id);
    if (!text) return Q_EMIT areaChanged();
    auto* const watcher = new QFutureWatcher<ReadArea>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, id] {
        watcher->deleteLater();
        if (id != m_areaId) return;  // another was chosen meanwhile
        m_area = watcher->result().area;
        m_chart = watcher->result().chart;
        Q_EMIT areaChanged();
    });
    watcher->setFuture(QtConcurrent::run([id, text] { return readAreaText(id, text); }));
}

const core::Vessel* EditorContext::vessel(const std::string& id) const {
    const auto known = m_vessels.find(id);
    if (known != m_vessels.end()) return known->second.get();
    const auto text = textOf(core::DocumentKind::Vessel, id);
    if (!text) return nullptr;
    auto vessel = core::loadVessel(id, *text);
    auto& kept = m_vessels[id];
    if (vessel) kept = std::make_unique<const core::Vessel>(std::move(vessel).value());
    return kept.get();
}

const core::Vessel* EditorContext::vesselAt(const std::string& path) const {
    const Json& document = m_draft.document();
    return vessel(textAt(document, join(shipPath(document, path), "vessel")));
}

const std::vector<EditorPort::Entry>& EditorContext::listed(core::DocumentKind kind) const {
    const auto known = m_lists.find(kind);
    return known != m_lists.end() ? known->second : m_lists[kind] = m_port.list(kind);
}

std::size_t EditorContext::shafts(const std::string& path) const {
    const core::Vessel* ship = vesselAt(path);
    return ship ? ship->propulsion.units.size() : 0;
}

std::vector<Option> EditorContext::choices(Source source, const std::string& path) const {
    const Json& document = m_draft.document();
    const core::Vessel* const ship = vesselAt(path);
    std::vector<Option> all;
    const auto add = [&](const std::string& id, const std::string& name) {
        all.push_back({id, QString::fromStdString(named(id, name))});
    };
    const auto addListed = [&](core::DocumentKind kind) {
        for (const EditorPort::Entry& e : listed(kind)) add(e.id, e.name);
    };
    switch (source) {
        case Source::None:
            break;
        case Source::Area:
            addListed(core::DocumentKind::Area);
            break;
        case Source::Vessel:
            addListed(core::DocumentKind::Vessel);
            break;
        case Source::Picture:
            addListed(core::DocumentKind::Picture);
            break;
        case Source::Berth:
            if (m_area)
                for (const core::Berth& b : m_area->berths) add(b.id, b.name);
            break;
        case Source::Bollard: {
            const std::string berth = textAt(document, join(shipPath(document, path), "berth.id"));
            if (const core::Berth* b = m_area ? m_area->findBerth(berth) : nullptr)
                for (const auto& bollard : b->bollards) add(bollard.id, {});
            break;
        }
        case Source::Fairlead:
            if (ship)
                for (const auto& fairlead : ship->mooring.fairleads) add(fairlead.id, {});
            break;
        case Source::Place:
            if (m_area)
                for (const core::Place& p : m_area->places) add(p.id, p.name);
            break;
        case Source::Ship:
            return idsIn(document, "ownShips", "name");
        case Source::Line:
            return idsIn(document, join(shipPath(document, path), "lines"), {});
        case Source::Shaft:
            if (ship)
                for (const auto& unit : ship->propulsion.units) add(unit.id, {});
            break;
        case Source::Anchor:
            if (ship)
                for (const auto& anchor : ship->groundTackle.anchors) add(anchor.id, {});
            break;
        case Source::Thruster:
            if (ship)
                for (const auto& thruster : ship->thrusters.units) add(thruster.id, {});
            break;
        case Source::Target:
            return idsIn(document, "traffic", "name");
        case Source::Event:
            return idsIn(document, "events", "title");
        case Source::Waypoint:
            for (std::size_t i = 0; i < sizeAt(document, "route.waypoints"); ++i) {
                const std::string number = std::to_string(i + 1);
                add(number, number + " " + textAt(document, join(join("route.waypoints", i), "name")));
            }
            break;
    }
    return all;
}

std::shared_ptr<const core::DocumentSource> EditorContext::documents() const {
    const Json& document = m_draft.document();
    (void)textOf(core::DocumentKind::Area, textAt(document, "area"));
    for (std::size_t i = 0; i < sizeAt(document, "ownShips"); ++i)
        (void)textOf(core::DocumentKind::Vessel, textAt(document, join(join("ownShips", i), "vessel")));
    std::set<std::string> pictures;
    for (const EditorPort::Entry& e : listed(core::DocumentKind::Picture)) pictures.insert(e.id);
    return std::make_shared<const TextsSource>(m_texts, std::move(pictures), m_port.hulls());
}

}  // namespace sagara::ui::editor
