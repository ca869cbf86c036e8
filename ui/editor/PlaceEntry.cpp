#include "ui/editor/PlaceEntry.h"

#include <QComboBox>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/editor/FieldText.h"

namespace sagara::ui::editor {
namespace {

const std::string kPosition = "#position";  ///< no place of an area is called so

Field positionField(const Field& field) {
    return position(field.key, field.label,
                    words("Or drag it on the chart; near a named place it takes that"));
}

}  // namespace

PlaceEntry::PlaceEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent)
    : FieldEditor(context, field, path, parent),
      m_combo(new QComboBox(this)),
      m_position(new LineEntry(context, positionField(field), path, this)) {
    m_combo->setObjectName(QString::fromStdString(path));
    m_combo->setToolTip(tip());
    m_combo->setAccessibleName(field.label);
    m_combo->setPlaceholderText(words("choose"));
    m_combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_combo->setMinimumContentsLength(12);
    keepWheelForPage(*m_combo);
    box()->addWidget(m_combo);
    box()->addWidget(m_position);
    connect(m_combo, &QComboBox::currentIndexChanged, this, &PlaceEntry::take);
    connect(&context, &EditorContext::areaChanged, this, &PlaceEntry::load);
}

/// Where the place is that is named now; else the middle of the chart.
core::GeoPoint PlaceEntry::here() const {
    const core::Area* const area = context().area().get();
    const bool named = value() && value()->is_string();
    const core::Place* const place =
        area && named ? area->findPlace(value()->get_ref<const std::string&>()) : nullptr;
    return place ? area->frame.toGeo(place->position) : context().newPlace();
}

void PlaceEntry::take(int index) {
    const std::string chosen = m_combo->itemData(index).toString().toStdString();
    if (chosen.empty()) return write(Json());
    Json place = chosen == kPosition ? positionJson(here()) : Json(chosen);
    const std::string list = path().ends_with(']') ? parentOf(path()) : std::string();
    context().draft().edit(words("change of %1").arg(field().label.toLower()), [&](Json& document) {
        if (!list.empty()) {
            const Json* const there = editor::find(document, list);
            Json all = there && there->is_array() ? *there : Json::array();
            while (all.size() <= indexOf(path())) all.push_back("");
            put(document, list, std::move(all));
        }
        put(document, path(), std::move(place));
    });
}

void PlaceEntry::load() {
    const bool free = value() && value()->is_object();
    std::vector<Option> options{{kPosition, words("a position on the chart")}};
    for (Option& place : context().choices(Source::Place, path())) options.push_back(std::move(place));
    const QString now = free ? QString::fromStdString(kPosition)
                        : value() && value()->is_string()
                            ? QString::fromStdString(value()->get<std::string>())
                            : QString();
    fillCombo(*m_combo, options, field().optional, now);
    m_position->setVisible(free);
    if (free) m_position->load();
}

void PlaceEntry::focusEntry() { m_combo->setFocus(); }

PlacesEntry::PlacesEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent)
    : FieldEditor(context, field, path, parent) {
    for (std::size_t i = 0; i < field.count; ++i) {
        m_places.push_back(new PlaceEntry(context, field, join(path, i), this));
        box()->addWidget(m_places.back());
    }
}

void PlacesEntry::load() {
    for (PlaceEntry* place : m_places) place->load();
}

void PlacesEntry::showProblems(const std::vector<core::config::Problem>& problems) {
    std::vector<core::config::Problem> own;
    std::copy_if(problems.begin(), problems.end(), std::back_inserter(own),
                 [this](const auto& p) { return p.path == path(); });
    FieldEditor::showProblems(own);
    for (PlaceEntry* place : m_places) place->showProblems(problems);
}

FieldEditor* PlacesEntry::reveal(const std::string& target) {
    for (PlaceEntry* place : m_places)
        if (within(target, place->path())) return place;
    return this;
}

void PlacesEntry::focusEntry() {
    if (!m_places.empty()) m_places.front()->focusEntry();
}

}  // namespace sagara::ui::editor
