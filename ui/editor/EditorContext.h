#pragma once

#include <QObject>
#include <map>
#include <memory>

#include "core/vessel/Vessel.h"
#include "core/world/Area.h"
#include "ui/editor/EditorPort.h"
#include "ui/editor/FieldSpec.h"
#include "ui/editor/ScenarioDraft.h"
#include "ui/theme/PaletteName.h"
#include "ui/widgets/PreparedChart.h"

namespace sagara::ui::editor {

/// The draft with what its names stand for: area, vessels, and what can be chosen in a field. The area is read
/// in another thread; until it is there its berths and places cannot be chosen.
class EditorContext final : public QObject {
    Q_OBJECT
public:
    EditorContext(EditorPort& port, ScenarioDraft& draft, QObject* parent = nullptr);

    EditorPort& port() const { return m_port; }
    ScenarioDraft& draft() const { return m_draft; }
    const std::shared_ptr<const core::Area>& area() const { return m_area; }
    const std::shared_ptr<const PreparedChart>& chart() const { return m_chart; }
    const core::Vessel* vessel(const std::string& id) const;  ///< null when there is none or it has faults
    /// The vessel of the own ship that a path belongs to; of the first where it belongs to none.
    const core::Vessel* vesselAt(const std::string& path) const;

    /// Read once; again after forgetLists.
    const std::vector<EditorPort::Entry>& listed(core::DocumentKind kind) const;
    void forgetLists() { m_lists.clear(); }
    std::vector<Option> choices(Source source, const std::string& path) const;
    std::size_t shafts(const std::string& path) const;
    /// The documents the draft names, for a worker thread.
    std::shared_ptr<const core::DocumentSource> documents() const;

    core::GeoPoint newPlace() const { return m_newPlace; }  ///< where a new point of the chart begins
    void setNewPlace(core::GeoPoint place) { m_newPlace = place; }
    PaletteName colours() const { return m_colours; }
    void setColours(PaletteName colours);
    /// The row chosen last, by its path: what the chart shows handles of.
    const std::string& selected() const { return m_selected; }
    void select(const std::string& row);
    void say(const QString& text) { Q_EMIT said(text); }

Q_SIGNALS:
    void areaChanged();
    void coloursChanged();
    void selectionChanged();
    void said(const QString& text);

private:
    std::shared_ptr<const std::string> textOf(core::DocumentKind kind, const std::string& id) const;
    void readArea();

    EditorPort& m_port;
    ScenarioDraft& m_draft;
    std::string m_areaId;
    std::string m_selected;
    std::shared_ptr<const core::Area> m_area;
    std::shared_ptr<const PreparedChart> m_chart;
    core::GeoPoint m_newPlace;
    PaletteName m_colours = PaletteName::Day;
    mutable std::map<std::pair<core::DocumentKind, std::string>, std::shared_ptr<const std::string>> m_texts;
    mutable std::map<core::DocumentKind, std::vector<EditorPort::Entry>> m_lists;
    mutable std::map<std::string, std::unique_ptr<const core::Vessel>> m_vessels;
};

}  // namespace sagara::ui::editor
