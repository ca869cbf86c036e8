#pragma once

#include "core/bridge/OwnShip.h"

/// Orders to one own ship, as given by wheel, telegraph, deck or a command file. Each is a value; `obey`
/// carries it out. An order that makes no sense at this moment (letting go an anchor that is down) is not an
/// error: it does nothing.
namespace sagara::core {

struct HelmOrder {
    double rudder_rad = 0.0;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.rudder_rad);
    }
};

/// Shaft number, or every shaft.
inline constexpr std::uint8_t kAllShafts = 255;

struct TelegraphOrder {
    std::uint8_t shaft = kAllShafts;
    TelegraphStep step = TelegraphStep::Stop;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.shaft, self.step);
    }
};

struct ShaftOrder {
    std::uint8_t shaft = kAllShafts;
    double speed_rps = 0.0;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.shaft, self.speed_rps);
    }
};

/// Pitch by hand, over the design pitch; the next order of lever or telegraph takes it back.
struct PitchOrder {
    std::uint8_t shaft = kAllShafts;
    double pitch = 1.0;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.shaft, self.pitch);
    }
};

/// Where an azimuth drive is to push the ship, clockwise from ahead.
struct AzimuthOrder {
    std::uint8_t shaft = kAllShafts;
    double angle_rad = 0.0;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.shaft, self.angle_rad);
    }
};

/// Lever of a bow or stern thruster.
struct ThrusterOrder {
    std::uint8_t thruster = 0;
    double share = 0.0;  ///< of full thrust, -1 to 1, starboard positive
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.thruster, self.share);
    }
};

struct AutopilotOrder {
    AutopilotMode mode = AutopilotMode::Off;
    double heading_rad = 0.0;  ///< heading mode
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.mode, self.heading_rad);
    }
};

/// The scripted pilot takes or gives back the ship.
struct PilotOrder {
    bool engage = false;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.engage);
    }
};

enum class LineAction : std::uint8_t { Hold, Slack, Heave, LetGo };
struct LineOrder {
    std::uint8_t line = 0;
    LineAction action = LineAction::Hold;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.line, self.action);
    }
};

enum class AnchorAction : std::uint8_t { LetGo, Veer, Hold, HeaveIn };
struct AnchorOrder {
    std::uint8_t anchor = 0;
    AnchorAction action = AnchorAction::Hold;
    double cable_m = 0.0;  ///< let go, veer, heave in: brake on at this much out
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.anchor, self.action, self.cable_m);
    }
};

void obey(const OwnShip& ship, OwnShipState& state, const HelmOrder& order);
void obey(const OwnShip& ship, OwnShipState& state, const TelegraphOrder& order);
void obey(const OwnShip& ship, OwnShipState& state, const ShaftOrder& order);
void obey(const OwnShip& ship, OwnShipState& state, const PitchOrder& order);
void obey(const OwnShip& ship, OwnShipState& state, const AzimuthOrder& order);
void obey(const OwnShip& ship, OwnShipState& state, const ThrusterOrder& order);
void obey(const OwnShip& ship, OwnShipState& state, const AutopilotOrder& order);
void obey(const OwnShip& ship, OwnShipState& state, const PilotOrder& order);
void obey(const OwnShip& ship, OwnShipState& state, const LineOrder& order);
void obey(const OwnShip& ship, OwnShipState& state, const AnchorOrder& order);

}  // namespace sagara::core
