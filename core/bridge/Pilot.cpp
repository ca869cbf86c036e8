#include "core/bridge/Pilot.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "core/bridge/ShipOrders.h"

namespace sagara::core {
namespace {

/// One tick of one step. Every `run` returns true when its step is done.
class PilotTick {
public:
    PilotTick(const RoutePath& path, const OwnShip& ship, OwnShipState& state, double dt_s)
        : m_path(path), m_ship(ship), m_state(state), m_memory(state.pilot), m_dt_s(dt_s) {}

    bool run(const LinesStep& step) {
        const auto order = [&](std::uint8_t mask, LineAction action) {
            for (std::uint8_t i = 0; i < m_ship.lines.size(); ++i) {
                if (mask & (1U << i)) obey(m_ship, m_state, LineOrder{i, action});
            }
        };
        if (m_memory.phase == 0) {
            order(step.hold, LineAction::Hold);
            order(step.slack, LineAction::Slack);
            order(step.heave, LineAction::Heave);
            order(step.letGo, LineAction::LetGo);
            enter(1);
        }
        return m_memory.since_s >= step.wait_s;
    }

    bool run(const RunStep& step) {
        if (m_memory.phase == 0) {
            // notes: heading at the start, distance run since
            m_memory.noteA = m_state.motion.heading_rad;
            m_memory.noteB = 0.0;
            enter(1);
        }
        m_memory.noteB += m_dt_s * std::hypot(m_state.motion.surge_mps, m_state.motion.sway_mps);
        steer(step.rudder_rad);
        for (std::uint8_t i = 0; i < m_ship.shaftCount(); ++i) shaft(i, step.shafts_rps[i]);
        const ShipMotion& m = m_state.motion;
        return m_memory.since_s >= step.atMost_s ||
               (step.headingChange_rad &&
                std::abs(m.heading_rad - m_memory.noteA) >= *step.headingChange_rad) ||
               (step.moved_m && m_memory.noteB >= *step.moved_m) ||
               (step.slowerThan_mps && m_memory.since_s > 5.0 &&
                std::hypot(m.surge_mps, m.sway_mps) < *step.slowerThan_mps);
    }

    bool run(const TurnStep& step) {
        const double error_rad = wrapPi(step.heading_rad - m_state.motion.heading_rad);
        // the way she has on is taken off at the same time
        const double common_rps = std::clamp(-1.5 * m_state.motion.surge_mps / m_ship.advancePerRev_m,
                                             -0.7 * step.shaft_rps, 0.7 * step.shaft_rps);
        twist(error_rad, step.shaft_rps, common_rps);
        constexpr double kOnHeading_rad = 8.0 * kDegree_rad, kSteady_radps = 1.2 * kDegree_rad;
        return std::abs(error_rad) < kOnHeading_rad && std::abs(m_state.motion.yawRate_radps) < kSteady_radps;
    }

    bool run(const TrackStep& step) {
        if (m_memory.phase == 0) {
            m_state.autopilot.offTrackSum_ms = 0.0;
            enter(1);
        }
        m_state.autopilot.mode = AutopilotMode::Track;  // also after he was away
        const RoutePath::Place here = m_path.at(m_state.autopilot.along_m);
        double wanted_mps =
            lowestSpeed_mps(step.speeds, m_state.motion.position(), here.leg, step.cruise_mps);
        // slow down in time for a circle ahead
        constexpr double kBraking_mps2 = 0.03, kEarly_m = 50.0;  // the GPS shows the speed of a while ago
        for (const SpeedZone& zone : step.speeds) {
            if (!zone.circle) continue;
            const double edge_m = distance(m_state.motion.position(), zone.centre) - zone.radius_m;
            const double off_m = std::max(0.0, edge_m - kEarly_m);
            wanted_mps = std::min(wanted_mps,
                                  std::sqrt(zone.speed_mps * zone.speed_mps + 2.0 * kBraking_mps2 * off_m));
        }
        runAt(wanted_mps);
        const bool done = m_state.autopilot.along_m >= step.untilAlong_m;
        if (done) steer(0.0);
        return done;
    }

    bool run(const AnchorStep& step) {
        switch (m_memory.phase) {
            case 0:
                return approach(step);
            case 1:
                return goAstern(step);
            case 2:
                return veer(step);
            default:
                return bringUp();
        }
    }

private:
    void enter(std::uint32_t phase) {
        m_memory.phase = phase;
        m_memory.since_s = 0.0;
    }
    void steer(double rudder_rad) { obey(m_ship, m_state, HelmOrder{rudder_rad}); }
    void shaft(std::uint8_t i, double speed_rps) { obey(m_ship, m_state, ShaftOrder{i, speed_rps}); }

    /// Shafts for a speed over the ground; note B gathers what wind and waves take.
    void runAt(double speed_mps) {
        constexpr double kGain = 1.2, kIntegralTime_s = 60.0, kMostIntegral_mps = 0.5;
        const double error_mps = speed_mps - waySpeed_mps();
        if (std::abs(error_mps) < 0.5) m_memory.noteB += error_mps * m_dt_s / kIntegralTime_s;
        m_memory.noteB = std::clamp(m_memory.noteB, -kMostIntegral_mps, kMostIntegral_mps);
        const double astern =
            m_ship.vessel.propulsion.telegraph_rps[static_cast<std::size_t>(TelegraphStep::SlowAstern)];
        shaft(kAllShafts,
              std::max(astern, (speed_mps + m_memory.noteB + kGain * error_mps) / m_ship.advancePerRev_m));
    }

    /// Turns the ship by her screws, with a common part of the shaft speed that works on her headway.
    void twist(double error_rad, double most_rps, double common_rps) {
        constexpr double kFull_rad = 20.0 * kDegree_rad, kLead_s = 8.0;
        const double turn =
            std::clamp((error_rad - kLead_s * m_state.motion.yawRate_radps) / kFull_rad, -1.0, 1.0);
        const double limit_rad = m_ship.vessel.steering.limit_rad;
        steer(turn * limit_rad);
        if (m_ship.shaftCount() < 2) {
            shaft(0, std::abs(turn) > 0.2 ? most_rps : common_rps);
            return;
        }
        // The astern screw is the weaker: it turns faster, so that she does not gather headway.
        const double forPort = turn * most_rps, asternGain = 1.25;
        const auto balanced = [&](double rps) { return rps < 0.0 ? asternGain * rps : rps; };
        shaft(0, common_rps + balanced(forPort));
        shaft(static_cast<std::uint8_t>(m_ship.shaftCount() - 1), common_rps + balanced(-forPort));
    }

    /// Between log and GPS: the one moves with every wave, the other comes late.
    double waySpeed_mps() const { return 0.5 * (m_state.motion.surge_mps + alongGround_mps()); }
    double alongGround_mps() const {
        return dot(m_state.shownOverGround_mps, unitVector(m_state.motion.heading_rad));
    }
    NorthEast hawse(const AnchorStep& step) const {
        return HeadingFrame(m_state.motion.position(), m_state.motion.heading_rad)
            .point(m_ship.vessel.groundTackle.anchors[step.anchor].hawse);
    }
    /// How far the hawse has to go on the last course until it is over the place.
    double toGo_m(const AnchorStep& step) const {
        return dot(step.place - hawse(step), unitVector(m_path.at(m_path.length_m()).course_rad));
    }

    bool approach(const AnchorStep& step) {
        m_state.autopilot.mode = AutopilotMode::Track;
        constexpr double kBraking_mps2 = 0.02,
                         kBeyond_m = 8.0;  // she falls back over the place before she lets go
        const double left_m = toGo_m(step) + kBeyond_m;
        runAt(std::min(step.approach_mps, std::sqrt(2.0 * kBraking_mps2 * std::max(0.0, left_m)) + 0.05));
        if (left_m < 4.0 || alongGround_mps() < 0.05) {
            enter(1);
        }
        return false;
    }

    /// Sternway at a speed over the ground, bow held up to the last course by the screws.
    void backAt(double astern_mps) {
        const double error_mps = -astern_mps - waySpeed_mps();
        const double dead =
            m_ship.vessel.propulsion.telegraph_rps[static_cast<std::size_t>(TelegraphStep::DeadSlowAstern)];
        const double common_rps = std::clamp(6.0 * error_mps, 1.5 * dead, -1.5 * dead);
        twist(wrapPi(m_path.at(m_path.length_m()).course_rad - m_state.motion.heading_rad), -0.8 * dead,
              common_rps);
    }

    bool goAstern(const AnchorStep& step) {
        constexpr double kSternway_mps = 0.28, kEnough_mps = 0.21;
        backAt(kSternway_mps);
        const bool near = distance(hawse(step), step.place) < 25.0;
        if (alongGround_mps() < -kEnough_mps && near) {
            obey(m_ship, m_state, AnchorOrder{step.anchor, AnchorAction::LetGo, step.firstCable_m});
            enter(2);
        }
        return false;
    }

    bool veer(const AnchorStep& step) {
        const AnchorState& anchor = m_state.anchors[step.anchor];
        if (anchor.onBottom && anchor.status == AnchorStatus::Held) {
            obey(m_ship, m_state, AnchorOrder{step.anchor, AnchorAction::Veer, step.cable_m});
        }
        // The cable is laid out along the ground, not piled up: she goes on until it has come up and pulls.
        const double hanging_m = m_state.underKeel_m + m_ship.vessel.hull.draught_m;
        const double reach_m = std::sqrt(std::max(1.0, step.cable_m * step.cable_m - hanging_m * hanging_m));
        const double left_m = reach_m - 4.0 - distance(hawse(step), anchor.position);
        constexpr double kLag_s = 8.0;  // of the ship and of the GPS
        backAt(std::clamp(0.035 * (left_m + kLag_s * alongGround_mps()), 0.1, 0.8));
        const bool out = anchor.status == AnchorStatus::Held && anchor.cableOut_m >= step.cable_m - 0.5;
        constexpr double kBroughtUp_N = 1500.0;
        if (out && (left_m < 5.0 || anchor.pull_N > kBroughtUp_N)) enter(3);
        return false;
    }

    /// A touch ahead or astern takes the way off her while she settles; then the engines stop and he stays on
    /// watch.
    bool bringUp() {
        constexpr double kSettling_s = 180.0, kStill_mps = 0.05, kTouch_rpsPerMps = 4.0;
        const double dead =
            m_ship.vessel.propulsion.telegraph_rps[static_cast<std::size_t>(TelegraphStep::DeadSlowAhead)];
        const double along_mps = alongGround_mps();
        const bool touch = m_memory.since_s < kSettling_s && std::abs(along_mps) > kStill_mps;
        steer(0.0);
        shaft(kAllShafts, touch ? std::clamp(-kTouch_rpsPerMps * along_mps, -dead, dead) : 0.0);
        return false;
    }

    const RoutePath& m_path;
    const OwnShip& m_ship;
    OwnShipState& m_state;
    PilotMemory& m_memory;
    double m_dt_s;
};

}  // namespace

void runPilot(const PilotScript& script, const RoutePath& path, const OwnShip& ship, OwnShipState& state,
              double dt_s) {
    PilotMemory& memory = state.pilot;
    if (!memory.engaged || memory.step >= script.size()) return;
    memory.since_s += dt_s;
    PilotTick tick(path, ship, state, dt_s);
    const bool done = std::visit([&](const auto& step) { return tick.run(step); }, script[memory.step]);
    if (!done) return;
    memory = PilotMemory{true, memory.step + 1, 0, 0.0, 0.0, 0.0};
}

}  // namespace sagara::core
