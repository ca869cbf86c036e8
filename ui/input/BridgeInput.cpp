#include "ui/input/BridgeInput.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::ui {
namespace {

constexpr double kLook_radps = 30.0 * core::kDegree_rad;
constexpr double kThrustStep = 0.2;
constexpr int kPitchSteps = 2, kAzimuthSteps = 3;  ///< of 5 % and 5 degrees, by a key

/// Orders by NMEA nearer to one another than this (a fifth of a degree, 0.3 %) are the same.
constexpr double kSameOrder = 0.0035;
/// What an order by NMEA is about; engines by their number from kEngines on.
enum NmeaSubject { kRudder, kThruster, kSternThruster, kHorn, kLook, kEngines };

template <typename... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};
template <typename... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

bool actsWhileHeld(BridgeAction action) {
    return action == BridgeAction::Horn || action == BridgeAction::LookLeft ||
           action == BridgeAction::LookRight;
}

/// Holding these down repeats them, as the keyboard repeats letters.
bool repeats(BridgeAction action) {
    return action == BridgeAction::RudderPort || action == BridgeAction::RudderStarboard ||
           action == BridgeAction::RudderPortFine || action == BridgeAction::RudderStarboardFine ||
           action >= BridgeAction::PitchAstern;
}

}  // namespace

BridgeInput::BridgeInput(QObject* parent)
    : QObject(parent), m_joysticks(new Joysticks(this)), m_nmea(new NmeaPort(this)) {
    setShip({});
    connectSources();
}

void BridgeInput::connectSources() {
    connect(m_joysticks, &Joysticks::axisMoved, this, &BridgeInput::takeAxis);
    connect(m_joysticks, &Joysticks::buttonChanged, this, &BridgeInput::takeButton);
    connect(m_joysticks, &Joysticks::unplugged, this, [this](int id, const QString& name) {
        letGo(id);
        Q_EMIT deviceLost(name);
    });
    connect(m_nmea, &NmeaPort::ordered, this, &BridgeInput::obey);
    connect(m_nmea, &NmeaPort::lost, this, &BridgeInput::deviceLost);
}

void BridgeInput::setShip(const BridgeShip& ship) {
    m_ship = ship;
    m_helm_rad = 0.0;
    m_thrust = m_sternThrust = 0.0;
    m_nmeaLast.clear();  // what the bridge says next is an order to this ship
    m_nmeaLevers.clear();
    m_steps.assign(static_cast<std::size_t>(std::max(0, ship.shafts)), core::TelegraphStep::Stop);
}

void BridgeInput::followTelegraph(int shaft, core::TelegraphStep step) {
    if (shaft >= 0 && shaft < m_ship.shafts) m_steps[static_cast<std::size_t>(shaft)] = step;
}

ControlMap BridgeInput::mapOf(const JoystickInfo& device) const {
    const auto known = m_maps.find(device.model);
    if (known == m_maps.end()) return usualMap(device.axes, device.buttons, device.hats);
    return fitted(known->second, device.axes, device.allButtons());
}

void BridgeInput::setMap(const std::string& model, const ControlMap& map) {
    m_maps[model] = map;
    // A control that has a new meaning has not been moved yet.
    for (const JoystickInfo& device : m_joysticks->devices()) {
        if (device.model != model) continue;
        letGo(device.id);
        for (int i = 0; i < device.axes; ++i) takeAxis(device.id, i, m_joysticks->axis(device.id, i));
    }
}

void BridgeInput::letGo(int id) {
    std::erase_if(m_axes, [id](const auto& entry) { return entry.first.first == id; });
    const std::vector<ButtonMap> held = m_held[id];
    m_held.erase(id);
    for (const ButtonMap& button : held) perform(button.action, button.shaft, false);
}

void BridgeInput::setPaused(bool paused) {
    if (paused) {
        letGoKeys();
        for (const JoystickInfo& device : m_joysticks->devices()) letGo(device.id);
        for (const JoystickInfo& device : m_joysticks->devices())
            for (int i = 0; i < device.axes; ++i) takeAxis(device.id, i, m_joysticks->axis(device.id, i));
    }
    blockSignals(paused);
}

void BridgeInput::takeAxis(int id, int axis, double raw) {
    const auto devices = m_joysticks->devices();
    const auto device =
        std::find_if(devices.begin(), devices.end(), [id](const auto& d) { return d.id == id; });
    if (device == devices.end()) return;
    const ControlMap map = mapOf(*device);
    if (axis < 0 || axis >= static_cast<int>(map.axes.size())) return;
    const AxisMap& meant = map.axes[static_cast<std::size_t>(axis)];
    if (!usable(meant.calibration)) return;
    AxisState& state = m_axes[{id, axis}];
    const double value = calibrated(meant.calibration, raw);
    const auto moved = state.gate.moved(value);
    if (moved) Q_EMIT anyActivity();
    switch (meant.use) {
        case AxisUse::None:
            break;
        case AxisUse::Rudder:
            if (moved) wantHelm(*moved * m_ship.rudderLimit_rad);
            break;
        case AxisUse::Telegraph:
            if (const auto step = state.lever.moved(value)) wantStep(meant.shaft, *step);
            break;
        case AxisUse::Thruster:
            if (moved) wantThruster(*moved);
            break;
        case AxisUse::Look:
            if (moved) Q_EMIT lookWanted(*moved * kLook_radps);
            break;
        case AxisUse::SternThruster:
            if (moved) wantSternThruster(*moved);
            break;
        case AxisUse::Pitch:
            if (moved) wantOfShafts(meant.shaft, &BridgeInput::pitchWanted, *moved);
            break;
        case AxisUse::Azimuth:
            if (moved) wantOfShafts(meant.shaft, &BridgeInput::azimuthWanted, *moved * core::kPi);
            break;
    }
}

void BridgeInput::takeButton(int id, int button, bool down) {
    const auto devices = m_joysticks->devices();
    const auto device =
        std::find_if(devices.begin(), devices.end(), [id](const auto& d) { return d.id == id; });
    if (device == devices.end()) return;
    if (down) Q_EMIT anyActivity();
    const ControlMap map = mapOf(*device);
    if (button < 0 || button >= static_cast<int>(map.buttons.size())) return;
    const ButtonMap& meant = map.buttons[static_cast<std::size_t>(button)];
    if (actsWhileHeld(meant.action)) {
        auto& held = m_held[id];
        if (down)
            held.push_back(meant);
        else
            std::erase(held, meant);
    }
    perform(meant.action, meant.shaft, down);
}

void BridgeInput::wantHelm(double rudder_rad) {
    m_helm_rad = std::clamp(rudder_rad, -m_ship.rudderLimit_rad, m_ship.rudderLimit_rad);
    Q_EMIT helmWanted(m_helm_rad);
}

void BridgeInput::wantStep(int shaft, core::TelegraphStep step) {
    for (int i = 0; i < m_ship.shafts; ++i) {
        if (shaft != kEveryShaft && shaft != i) continue;
        m_steps[static_cast<std::size_t>(i)] = step;
        Q_EMIT telegraphWanted(i, step);
    }
}

template <typename Signal, typename Value>
void BridgeInput::wantOfShafts(int shaft, Signal signal, Value value) {
    for (int i = 0; i < m_ship.shafts; ++i)
        if (shaft == kEveryShaft || shaft == i) Q_EMIT(this->*signal)(i, value);
}

void BridgeInput::shiftStep(int shaft, int steps) {
    for (int i = 0; i < m_ship.shafts; ++i)
        if (shaft == kEveryShaft || shaft == i)
            wantStep(i, stepBy(m_steps[static_cast<std::size_t>(i)], steps));
}

void BridgeInput::wantThruster(double thrust) {
    m_thrust = std::clamp(thrust, -1.0, 1.0);
    Q_EMIT thrusterWanted(m_thrust);
}

void BridgeInput::wantSternThruster(double thrust) {
    m_sternThrust = std::clamp(thrust, -1.0, 1.0);
    Q_EMIT sternThrusterWanted(m_sternThrust);
}

void BridgeInput::perform(BridgeAction action, int shaft, bool down) {
    if (action == BridgeAction::Horn) Q_EMIT hornWanted(down);
    if (action == BridgeAction::LookLeft) Q_EMIT lookWanted(down ? -kLook_radps : 0.0);
    if (action == BridgeAction::LookRight) Q_EMIT lookWanted(down ? kLook_radps : 0.0);
    if (!down) return;
    switch (action) {
        case BridgeAction::TelegraphUp:
            return shiftStep(shaft, 1);
        case BridgeAction::TelegraphDown:
            return shiftStep(shaft, -1);
        case BridgeAction::StopEngines:
            return wantStep(shaft, core::TelegraphStep::Stop);
        case BridgeAction::RudderPort:
            return wantHelm(m_helm_rad - 5.0 * core::kDegree_rad);
        case BridgeAction::RudderStarboard:
            return wantHelm(m_helm_rad + 5.0 * core::kDegree_rad);
        case BridgeAction::RudderPortFine:
            return wantHelm(m_helm_rad - core::kDegree_rad);
        case BridgeAction::RudderStarboardFine:
            return wantHelm(m_helm_rad + core::kDegree_rad);
        case BridgeAction::Midships:
            return wantHelm(0.0);
        case BridgeAction::ThrusterPort:
            return wantThruster(m_thrust - kThrustStep);
        case BridgeAction::ThrusterStarboard:
            return wantThruster(m_thrust + kThrustStep);
        case BridgeAction::ThrusterStop:
            return wantThruster(0.0);
        case BridgeAction::SternThrusterPort:
            return wantSternThruster(m_sternThrust - kThrustStep);
        case BridgeAction::SternThrusterStarboard:
            return wantSternThruster(m_sternThrust + kThrustStep);
        case BridgeAction::SternThrusterStop:
            return wantSternThruster(0.0);
        case BridgeAction::PitchAstern:
            return wantOfShafts(shaft, &BridgeInput::pitchShiftWanted, -kPitchSteps);
        case BridgeAction::PitchAhead:
            return wantOfShafts(shaft, &BridgeInput::pitchShiftWanted, kPitchSteps);
        case BridgeAction::AzimuthPort:
            return wantOfShafts(shaft, &BridgeInput::azimuthShiftWanted, -kAzimuthSteps);
        case BridgeAction::AzimuthStarboard:
            return wantOfShafts(shaft, &BridgeInput::azimuthShiftWanted, kAzimuthSteps);
        case BridgeAction::Acknowledge:
            return Q_EMIT acknowledgeWanted();
        case BridgeAction::Bookmark:
            return Q_EMIT bookmarkWanted();
        case BridgeAction::None:
        case BridgeAction::Horn:
        case BridgeAction::LookLeft:
        case BridgeAction::LookRight:
            return;
    }
}

bool BridgeInput::isNew(int what, double value) {
    const auto [known, first] = m_nmeaLast.try_emplace(what, value);
    if (!first && std::abs(known->second - value) < kSameOrder) return false;
    known->second = value;
    return true;
}

void BridgeInput::obeyStep(int engine, core::TelegraphStep step) {
    const auto shaft = shaftOfEngine(engine, m_ship.shafts);
    if (!shaft || !isNew(kEngines + engine, leverOf(step))) return;
    Q_EMIT anyActivity();
    wantStep(*shaft, step);
}

void BridgeInput::obey(const NmeaOrder& order) {
    std::visit(Overloaded{[this](const NmeaRudder& o) {
                              if (!isNew(kRudder, o.rudder_rad)) return;
                              Q_EMIT anyActivity();
                              wantHelm(o.rudder_rad);
                          },
                          [this](const NmeaTelegraph& o) { obeyStep(o.engine, o.step); },
                          [this](const NmeaLever& o) {
                              const auto [lever, first] = m_nmeaLevers.try_emplace(o.engine);
                              const auto step = lever->second.moved(o.lever);
                              if (step || first) obeyStep(o.engine, step.value_or(nearestStep(o.lever)));
                          },
                          [this](const NmeaThruster& o) {
                              if (!isNew(o.atStern ? kSternThruster : kThruster, o.thrust)) return;
                              Q_EMIT anyActivity();
                              o.atStern ? wantSternThruster(o.thrust) : wantThruster(o.thrust);
                          },
                          [this](const NmeaHorn& o) {
                              if (!isNew(kHorn, o.on ? 1.0 : 0.0)) return;
                              Q_EMIT anyActivity();
                              Q_EMIT hornWanted(o.on);
                          },
                          [this](const NmeaLook& o) {
                              if (!isNew(kLook, o.yaw_radps)) return;
                              Q_EMIT anyActivity();
                              Q_EMIT lookWanted(o.yaw_radps);
                          },
                          [this](const NmeaAcknowledge&) {
                              Q_EMIT anyActivity();
                              Q_EMIT acknowledgeWanted();
                          },
                          [this](const NmeaBookmark&) {
                              Q_EMIT anyActivity();
                              Q_EMIT bookmarkWanted();
                          }},
               order);
}

void BridgeInput::watchKeys(QWidget* window) {
    if (m_window == nullptr && window != nullptr) qApp->installEventFilter(this);
    if (window == nullptr) qApp->removeEventFilter(this);
    m_window = window;
    letGoKeys();
}

void BridgeInput::letGoKeys() {
    for (const auto& [key, held] : std::exchange(m_heldKeys, {})) perform(held.first, held.second, false);
}

bool BridgeInput::eventFilter(QObject* object, QEvent* event) {
    // Another window will hear of the release.
    if (event->type() == QEvent::WindowDeactivate && object == m_window) letGoKeys();
    const bool press = event->type() == QEvent::KeyPress;
    if (!press && event->type() != QEvent::KeyRelease) return false;
    const auto* const widget = qobject_cast<QWidget*>(object);
    if (widget == nullptr || m_window == nullptr) return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const auto held = m_heldKeys.find(key.key());
    if (!press) {
        if (held == m_heldKeys.end()) return false;
        if (key.isAutoRepeat()) return true;
        const auto [action, shaft] = held->second;
        m_heldKeys.erase(held);
        perform(action, shaft, false);
        return true;
    }
    // The bridge may be a page of a window: its keys are orders while it is the page that is shown.
    if (widget->window() != m_window->window() || !m_window->isVisible() || keepsKey(widget, key))
        return false;
    const auto action = actionOf(m_keys, key);
    if (!action) return false;
    if (key.isAutoRepeat() && !repeats(*action)) return true;
    Q_EMIT anyActivity();
    if (actsWhileHeld(*action)) m_heldKeys[key.key()] = {*action, kEveryShaft};
    perform(*action, kEveryShaft, true);
    return true;
}

}  // namespace sagara::ui
