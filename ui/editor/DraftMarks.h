#pragma once

#include "core/base/LocalFrame.h"
#include "core/world/Area.h"
#include "ui/editor/ScenarioFields.h"

/// The marks a scenario puts into its area.
namespace sagara::ui::editor {

/// What a mark can be, with its name for a person; in the order they are offered.
const std::vector<Option>& markKinds();
Section marksSection();

/// A mark of this kind where a person clicked, with an id and a name that no other mark of the draft has.
Json newMark(const Json& document, const std::string& kind, core::GeoPoint place);

/// As the loader reads it; whatever is wrong with the row is harmless here.
core::Mark markOf(const Json& row, const core::LocalFrame& frame);

}  // namespace sagara::ui::editor
