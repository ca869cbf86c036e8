#pragma once

#include <optional>

#include "core/base/Config.h"
#include "core/world/Area.h"

namespace sagara::core {

/// What a mark need not say. Those of an area say everything: no light without height and range.
struct MarkDefaults {
    bool fictional = false;
    std::optional<double> lightHeight_m;  ///< above the water
    std::optional<double> lightRange_M;
};

inline constexpr MarkDefaults kScenarioMark{true, 4.0, 4.0};

/// One of "marks": {"id", "name", "kind", "at"}, if wanted "floating", "fictional", "source" and "light" with
/// "character", "height_m", "range_M".
Mark readMark(config::Reader& in, const LocalFrame& frame, const MarkDefaults& defaults = {});

/// The marks a scenario puts into its area, from "marks": each in the area's chart, those that float in the
/// water, no id or name twice nor one of the area's, every light a character that can be shown. Not in the
/// area yet.
std::vector<Mark> readScenarioMarks(config::Reader& scenario, const Area& area);

}  // namespace sagara::core
