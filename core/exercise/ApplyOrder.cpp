#include "core/exercise/ApplyOrder.h"

#include <algorithm>

namespace sagara::core {
namespace {

constexpr double kLevelRamp_s = 60.0;

Event make(const State& state, EventKind kind, std::uint8_t ship, std::size_t index, NorthEast place = {}) {
    Event e;
    e.tick = state.tick;
    e.kind = kind;
    e.ship = ship;
    e.index = static_cast<std::int32_t>(index);
    e.place = place;
    return e;
}

/// At most so many bytes, and no half of a letter of UTF-8 at the end.
std::string cutText(const std::string& text, std::size_t most_bytes) {
    std::size_t end = std::min(text.size(), most_bytes);
    while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    return text.substr(0, end);
}

/// Carries out the orders that are not for one own ship.
class Instructor {
public:
    Instructor(const World& world, State& state, std::uint8_t ship, std::vector<Event>& events)
        : m_world(world), m_state(state), m_ship(ship), m_events(events) {}

    void apply(const WeatherOrder& order) {
        // What a trainer orders is what comes; a later change of level scales it from there.
        const LevelPreset& level = m_world.level(m_state.level);
        Weather w = scaled(m_state.weather.base, level);
        w.wind.speed_mps = order.windSpeed_mps.value_or(w.wind.speed_mps);
        w.wind.windFrom_rad = order.windFrom_rad.value_or(w.wind.windFrom_rad);
        w.wind.gustiness = order.gustiness.value_or(w.wind.gustiness);
        for (std::size_t i = 0; i < kMostSwells; ++i) w.swells[i] = order.swells[i].value_or(w.swells[i]);
        w.current = order.current.value_or(w.current);
        w.visibility_m = order.visibility_m.value_or(w.visibility_m);
        w.rain = order.rain.value_or(w.rain);
        changeWeather(m_state.weather, unscaled(w, level), level, m_state.tick, order.ramp_s);
    }

    void apply(const FaultOrder& order) {
        OwnShipState& ship = m_state.ships[m_ship];
        switch (order.fault) {
            case Fault::SteeringPump:
                ship.steering.pumpsFailed =
                    order.mended ? std::uint8_t{0} : std::clamp<std::uint8_t>(order.number, 1, 2);
                break;
            case Fault::SteeringJam:
                ship.steering.jammed = !order.mended;
                break;
            case Fault::Engine:
                if (order.number >= m_world.ships[m_ship]->shaftCount()) return;
                ship.shafts[order.number].failed = !order.mended;
                break;
            case Fault::Thruster:
                if (order.number >= m_world.ships[m_ship]->thrusterCount()) return;
                ship.thrusters[order.number].failed = !order.mended;
                break;
        }
        Event event = make(m_state, order.mended ? EventKind::FaultMended : EventKind::FaultCame, m_ship,
                           static_cast<std::size_t>(order.fault), ship.motion.position());
        event.value = order.number;
        m_events.push_back(event);
    }

    void apply(const TargetOrder& order) {
        if (order.target >= m_state.targets.size()) return;
        TargetState& target = m_state.targets[order.target];
        switch (order.action) {
            case TargetAction::Appear:
                if (target.present) return;
                target = startOf(targetLayout(m_world, m_state, order.target));
                target.present = true;
                m_events.push_back(
                    make(m_state, EventKind::TargetAppeared, 0, order.target, target.position));
                break;
            case TargetAction::Remove:
                if (!target.present) return;
                target.present = false;
                m_events.push_back(make(m_state, EventKind::TargetGone, 0, order.target, target.position));
                break;
            case TargetAction::Stop:
                target.stopped = true;
                break;
            case TargetAction::Resume:
                resumeOwn(target);
                break;
            case TargetAction::SetSpeed:
                if (order.speed_mps >= 0.0 && order.speed_mps <= kFastestTarget_mps)
                    target.orderedSpeed_mps = order.speed_mps;
                break;
        }
    }

    void apply(const AddTargetOrder& order) {
        if (!carryOut(m_world, m_state, order)) return;
        m_events.push_back(make(m_state, EventKind::TargetAppeared, 0, m_state.targets.size() - 1,
                                m_state.targets.back().position));
    }
    void apply(const MoveTargetOrder& order) {
        if (!carryOut(m_world, m_state, order)) return;
        m_events.push_back(make(m_state, EventKind::TargetMoved, 0, order.target, order.position));
    }
    void apply(const SteerTargetOrder& order) { (void)carryOut(m_world, m_state, order); }
    void apply(const RouteTargetOrder& order) { (void)carryOut(m_world, m_state, order); }

    void apply(const NoteOrder& order) {
        Event event = make(m_state, EventKind::NoteMade, m_ship, 0, m_state.ships[m_ship].motion.position());
        event.value = order.bookmark ? 1.0 : 0.0;
        event.text = cutText(order.text, kLongestNote_bytes);
        m_events.push_back(std::move(event));
    }

    void apply(const ReportOrder& order) {
        if (order.kind > kLastReportKind) return;
        m_events.push_back(make(m_state, EventKind::Reported, m_ship, static_cast<std::size_t>(order.kind),
                                m_state.ships[m_ship].motion.position()));
    }

    void apply(const FreezeMotionOrder& order) {
        OwnShipState& ship = m_state.ships[m_ship];
        ship.freeMotions = order.free & kAllMotions;
        holdMotions(ship.freeMotions, ship.motion);
        m_events.push_back(
            make(m_state, EventKind::MotionsFreed, m_ship, ship.freeMotions, ship.motion.position()));
    }

    void apply(const DifficultyOrder& order) {
        const int level = std::clamp<int>(order.level, 1, kLevels);
        if (level == m_state.level) return;
        m_state.level = level;
        changeWeather(m_state.weather, m_state.weather.base, m_world.level(level), m_state.tick,
                      kLevelRamp_s);
        bringTargets(m_world, m_state, m_events);
        m_events.push_back(make(m_state, EventKind::LevelChanged, 0, static_cast<std::size_t>(level)));
    }

    void apply(const TriggerOrder& order) {
        if (order.event < m_world.events.size()) fireEvent(m_world, m_state, order.event, m_events);
    }

    void apply(const FinishOrder&) { m_state.finished = true; }

    template <typename ShipOrder>
    void apply(const ShipOrder& order) {
        obey(*m_world.ships[m_ship], m_state.ships[m_ship], order);
    }

private:
    const World& m_world;
    State& m_state;
    std::uint8_t m_ship;
    std::vector<Event>& m_events;
};

}  // namespace

void applyOrder(const World& world, State& state, std::uint8_t ship, const Order& order,
                std::vector<Event>& events) {
    if (ship >= state.ships.size()) return;
    Instructor instructor(world, state, ship, events);
    std::visit([&](const auto& given) { instructor.apply(given); }, order);
}

void fireEvent(const World& world, State& state, std::uint32_t index, std::vector<Event>& events) {
    if (state.fired[index]) return;
    state.fired[index] = 1;
    events.push_back(make(state, EventKind::ScenarioEvent, 0, index));
    for (const ScenarioEvent::Given& given : world.events[index].orders) {
        applyOrder(world, state, given.ship, given.order, events);
    }
}

void bringTargets(const World& world, State& state, std::vector<Event>& events) {
    for (std::uint32_t i = 0; i < world.targets.size(); ++i) {
        const TargetLayout& layout = world.targets[i];
        if (layout.onEvent) continue;
        const TargetAction action =
            state.level >= layout.fromLevel ? TargetAction::Appear : TargetAction::Remove;
        applyOrder(world, state, 0, TargetOrder{i, action, 0.0}, events);
    }
}

}  // namespace sagara::core
