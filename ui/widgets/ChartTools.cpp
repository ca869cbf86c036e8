#include "ui/widgets/ChartTools.h"

namespace sagara::ui {

void ChartTools::beginRange(core::NorthEast from, bool fromOwnShip) {
    m_range = Range{from, from, fromOwnShip};
    m_dragging = true;
}

void ChartTools::beginRule(core::NorthEast through, double directionOfNew_rad) {
    m_rule = Rule{through, m_rule ? m_rule->direction_rad : directionOfNew_rad};
    m_dragging = true;
}

void ChartTools::drag(core::NorthEast p, bool turn) {
    if (!m_dragging) return;
    if (m_tool == Tool::RangeBearing && m_range) m_range->to = p;
    if (m_tool != Tool::ParallelRule || !m_rule) return;
    if (!turn) {
        m_rule->through = p;
    } else if (core::distance(m_rule->through, p) > 0.0) {
        m_rule->direction_rad = core::bearing_rad(m_rule->through, p);
    }
}

void ChartTools::ownShipAt(core::NorthEast p) {
    if (m_range && m_range->fromOwnShip) m_range->from = p;
}

bool ChartTools::cancel() {
    m_dragging = false;
    if (m_tool == Tool::None) {
        const bool any = m_range || m_rule;
        m_range.reset();
        m_rule.reset();
        return any;
    }
    if (m_tool == Tool::RangeBearing && m_range) {
        m_range.reset();
    } else if (m_tool == Tool::ParallelRule && m_rule) {
        m_rule.reset();
    } else {
        m_tool = Tool::None;
    }
    return true;
}

double ChartTools::offset_m(const Rule& rule, core::NorthEast from) {
    return core::cross(core::unitVector(rule.direction_rad), rule.through - from);
}

}  // namespace sagara::ui
