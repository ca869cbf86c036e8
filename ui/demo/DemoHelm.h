#pragma once

#include <optional>
#include <vector>

#include "core/exercise/Snapshot.h"

namespace sagara::ui {

/// What a joystick says, if there is one. Both axes -1 to 1: starboard and ahead are positive.
struct StickReading {
    double rudder = 0.0;
    double engine = 0.0;
    bool pressed = false;  ///< any button
    friend bool operator==(const StickReading&, const StickReading&) = default;
};

/// A visitor at the helm: a few keys, one rudder, all engines together. Keeps what was ordered; every call
/// returns the orders that follow. No Qt.
class DemoHelm final {
public:
    enum class Key { Port, Starboard, Midships, Faster, Slower };
    using Orders = std::vector<core::Order>;

    /// Takes the ship from the pilot as she goes, at least at slow ahead: a ship that lies still is no show.
    Orders take(const core::OwnShip& ship, const core::OwnShipView& now);
    Orders press(Key key);
    /// Only what has moved since the last reading gives an order.
    Orders move(const StickReading& stick);

    double rudder_rad() const { return m_rudder_rad; }
    core::TelegraphStep step() const { return m_step; }

private:
    Orders orderRudder(double rudder_rad);
    Orders orderStep(int step);

    double m_limit_rad = 0.6;
    double m_rudder_rad = 0.0;
    core::TelegraphStep m_step = core::TelegraphStep::Stop;
    std::optional<StickReading> m_stick;
};

/// Has anybody moved the stick, beyond what a worn one trembles?
bool stickMoved(const StickReading& before, const StickReading& now);

}  // namespace sagara::ui
