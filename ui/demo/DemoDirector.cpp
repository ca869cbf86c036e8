#include "ui/demo/DemoDirector.h"

#include <algorithm>

namespace sagara::ui {

std::optional<DemoDirector::Act> DemoDirector::enter(Phase phase, Act act) {
    m_phase = phase;
    m_inPhase_s = m_untouched_s = m_camera_s = m_spoilt_s = 0.0;
    return act;
}

std::optional<DemoDirector::Act> DemoDirector::advance(double elapsed_s, bool over, bool spoilt) {
    m_inPhase_s += elapsed_s;
    m_untouched_s += elapsed_s;
    switch (m_phase) {
        case Phase::Attract:
            if (over) return enter(Phase::Attract, Act::Reset);
            m_camera_s += elapsed_s;
            if (m_camera_s < m_timing.camera_s) return std::nullopt;
            m_camera_s = 0.0;
            return Act::NextCamera;
        case Phase::Helm:
            return advanceHelm(elapsed_s, over, spoilt);
        case Phase::Score:
            if (m_inPhase_s < m_timing.score_s) return std::nullopt;
            return enter(Phase::Attract, Act::Reset);
    }
    return std::nullopt;
}

std::optional<DemoDirector::Act> DemoDirector::advanceHelm(double elapsed_s, bool over, bool spoilt) {
    if (m_untouched_s >= m_timing.idle_s) return enter(Phase::Attract, Act::Reset);
    if (over || m_inPhase_s >= m_timing.helm_s) return enter(Phase::Score, Act::ShowScore);
    m_spoilt_s = spoilt ? m_spoilt_s + elapsed_s : 0.0;
    if (spoilt && m_spoilt_s >= m_timing.aground_s) return enter(Phase::Score, Act::ShowScore);
    return std::nullopt;
}

std::optional<DemoDirector::Act> DemoDirector::touched() {
    m_untouched_s = 0.0;
    switch (m_phase) {
        case Phase::Attract:
            return enter(Phase::Helm, Act::TakeHelm);
        case Phase::Helm:
            return std::nullopt;
        case Phase::Score:
            if (m_inPhase_s < m_timing.leastScore_s) return std::nullopt;
            return enter(Phase::Attract, Act::Reset);
    }
    return std::nullopt;
}

double DemoDirector::helmLeft_s() const {
    return m_phase == Phase::Helm ? std::max(0.0, m_timing.helm_s - m_inPhase_s) : 0.0;
}

double DemoDirector::idleLeft_s() const { return std::max(0.0, m_timing.idle_s - m_untouched_s); }

}  // namespace sagara::ui
