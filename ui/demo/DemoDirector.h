#pragma once

#include <cstdint>
#include <optional>

namespace sagara::ui {

struct DemoTiming {
    double camera_s = 12.0;     ///< before the next camera
    double helm_s = 180.0;      ///< a visitor has the ship
    double idle_s = 60.0;       ///< without a touch, and the visitor is taken to have gone
    double score_s = 20.0;      ///< the score is shown
    double leastScore_s = 2.0;  ///< before a touch takes it away: visitors are still pressing keys
    double aground_s = 5.0;     ///< after the lesson was spoilt, before the score
};

/// Who has the ship of the exhibition. Fed with elapsed time and touches; says what is to be done. No clock,
/// no Qt.
class DemoDirector final {
public:
    enum class Phase : std::uint8_t { Attract, Helm, Score };
    enum class Act : std::uint8_t {
        NextCamera,  ///< of the attract show
        TakeHelm,    ///< the pilot gives the ship to the visitor
        ShowScore,
        Reset  ///< back to the first State, with the pilot
    };

    explicit DemoDirector(DemoTiming timing) : m_timing(timing) {}

    /// Time has passed. `over`: the lesson has ended; `spoilt`: she is aground or has hit something.
    std::optional<Act> advance(double elapsed_s, bool over, bool spoilt = false);
    /// A key, a click, the joystick.
    std::optional<Act> touched();

    Phase phase() const { return m_phase; }
    double helmLeft_s() const;  ///< until the helm is given back
    double idleLeft_s() const;  ///< until a visitor who touches nothing is taken to have gone

private:
    std::optional<Act> enter(Phase phase, Act act);
    std::optional<Act> advanceHelm(double elapsed_s, bool over, bool spoilt);

    DemoTiming m_timing;
    Phase m_phase = Phase::Attract;
    double m_inPhase_s = 0.0;
    double m_untouched_s = 0.0;
    double m_camera_s = 0.0;
    double m_spoilt_s = 0.0;
};

}  // namespace sagara::ui
