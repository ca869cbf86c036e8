#pragma once

#include <optional>

#include "core/base/Planar.h"

namespace sagara::ui {

/// CONTROLLER of the measuring tools of a chart, in frame N. Owns no widget: the chart feeds it places.
class ChartTools {
public:
    enum class Tool { None, RangeBearing, ParallelRule };

    /// A line from a place, or from the own ship as she moves.
    struct Range {
        core::NorthEast from;
        core::NorthEast to;
        bool fromOwnShip = false;
    };
    /// A straight line that keeps its direction while it is dragged.
    struct Rule {
        core::NorthEast through;
        double direction_rad = 0.0;
    };

    Tool tool() const { return m_tool; }
    const std::optional<Range>& range() const { return m_range; }
    const std::optional<Rule>& rule() const { return m_rule; }

    /// What was measured stays until it is measured anew or cancelled.
    void choose(Tool tool) { m_tool = tool; }
    void beginRange(core::NorthEast from, bool fromOwnShip);
    /// A rule that is there keeps its direction; a new one takes that of what it is laid along.
    void beginRule(core::NorthEast through, double directionOfNew_rad);
    /// The line drawn on, or the rule moved. `turn`: the rule is turned about its place instead, to lie
    /// through p.
    void drag(core::NorthEast p, bool turn = false);
    void release() { m_dragging = false; }
    bool dragging() const { return m_dragging; }
    void ownShipAt(core::NorthEast p);

    /// One step back: first what is measured with this tool goes, then the tool. False when there was
    /// nothing.
    bool cancel();

    /// Distance of the rule from a place; positive when the rule lies to starboard of it, as seen along the
    /// rule.
    static double offset_m(const Rule& rule, core::NorthEast from);

private:
    Tool m_tool = Tool::None;
    std::optional<Range> m_range;
    std::optional<Rule> m_rule;
    bool m_dragging = false;
};

}  // namespace sagara::ui
