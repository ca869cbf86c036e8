#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/bridge/OwnShip.h"
#include "core/exercise/Weather.h"

/// Orders of the trainer, and of the events a scenario carries. Values only; see ApplyOrder.h.
namespace sagara::core {

/// New weather, from what is now; what is not given stays.
struct WeatherOrder {
    std::optional<double> windSpeed_mps;
    std::optional<double> windFrom_rad;
    std::optional<double> gustiness;
    std::array<std::optional<WaveSystem>, kMostSwells> swells;
    std::optional<NorthEast> current;
    std::optional<double> visibility_m;
    std::optional<double> rain;
    double ramp_s = 0.0;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.windSpeed_mps, self.windFrom_rad, self.gustiness, self.swells, self.current,
           self.visibility_m, self.rain, self.ramp_s);
    }
};

enum class Fault : std::uint8_t { SteeringPump, SteeringJam, Engine, Thruster };
/// A fault on an own ship comes (or is mended).
struct FaultOrder {
    Fault fault = Fault::Engine;
    std::uint8_t number = 0;  ///< of the engine or thruster; pumps: how many fail
    bool mended = false;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.fault, self.number, self.mended);
    }
};

enum class TargetAction : std::uint8_t { Appear, Remove, Stop, Resume, SetSpeed };
struct TargetOrder {
    std::uint32_t target = 0;
    TargetAction action = TargetAction::Appear;
    double speed_mps = 0.0;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.target, self.action, self.speed_mps);
    }
};

/// Difficulty 1 to 5: weather goes over in a minute, traffic and threats come and go.
struct DifficultyOrder {
    std::uint8_t level = 1;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.level);
    }
};

/// Fires an event of the scenario, whatever its own trigger.
struct TriggerOrder {
    std::uint32_t event = 0;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.event);
    }
};

/// A note of the trainer, or only a bookmark: an event that the recording keeps; nothing else changes.
struct NoteOrder {
    std::string text;  ///< UTF-8, at most kLongestNote_bytes; may be empty with a bookmark
    bool bookmark = false;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.text, self.bookmark);
    }
};
inline constexpr std::size_t kLongestNote_bytes = 500;

/// What the trainee reports from the bridge: an event; nothing else changes.
enum class ReportKind : std::uint8_t { PortControl, Anchored, ManOverboard };
inline constexpr ReportKind kLastReportKind = ReportKind::ManOverboard;
const char* reportKindName(ReportKind kind);  ///< as documents say it
struct ReportOrder {
    ReportKind kind = ReportKind::PortControl;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.kind);
    }
};

/// For the classroom: only these motions of the own ship are free, the others are held.
struct FreezeMotionOrder {
    std::uint8_t free = kAllMotions;  ///< bits of FreeMotion
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.free);
    }
};

/// Ends the exercise; it is graded as it stands.
struct FinishOrder {
    template <typename Archive, typename Self>
    static void fields(Archive&, Self&) {}
};

}  // namespace sagara::core
