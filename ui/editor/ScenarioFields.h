#pragma once

#include "ui/editor/FieldSpec.h"

namespace sagara::ui::editor {

/// A page of the form.
struct Section {
    std::string id;  ///< "route"
    QString title;
    QString icon;    ///< of assets/icons
    QString about;   ///< one sentence for who sees it first
    std::vector<Field> fields;  ///< keys are paths in the document
    bool holds(const std::string& path) const;
};

/// In the order they are shown.
std::vector<Section> scenarioSections();

// MissionFields.cpp, OrderFields.cpp
ListSpec taskList();
ListSpec criterionList();
ListSpec orderList();
ListSpec pilotList();
ListSpec speedZoneList();
ListSpec swellList();

/// A new row of a list as the tables have it; references and places are the caller's.
Json initialRow(const ListSpec& spec, const Variant* variant);

/// What a new scenario begins with.
struct NewScenario {
    std::string id;
    std::string name;
    std::string area;
    std::string vessel;
    double lat_deg = 0.0;  ///< where she starts
    double lon_deg = 0.0;
};
/// All that every scenario has, with nothing in it: no route, no traffic, no task.
Json emptyScenario(const NewScenario& choice);

}  // namespace sagara::ui::editor
