#pragma once

#include <QString>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/input/Calibration.h"

/// Which control does what. Stored as text in the settings.
namespace sagara::ui {

enum class AxisUse { None, Rudder, Telegraph, Thruster, Look, SternThruster, Pitch, Azimuth };
inline constexpr AxisUse kAxisUses[] = {AxisUse::None,     AxisUse::Rudder, AxisUse::Telegraph,
                                        AxisUse::Thruster, AxisUse::Look,   AxisUse::SternThruster,
                                        AxisUse::Pitch,    AxisUse::Azimuth};
QString axisUseText(AxisUse use);
/// Uses that are for one shaft or for all.
bool needsShaft(AxisUse use);

/// What a button or a key does.
enum class BridgeAction {
    None,
    Horn,  ///< as long as it is held
    TelegraphUp,
    TelegraphDown,
    StopEngines,
    RudderPort,       ///< 5 degrees more to port
    RudderStarboard,  ///< 5 degrees
    RudderPortFine,   ///< 1 degree
    RudderStarboardFine,
    Midships,
    ThrusterPort,       ///< bow thruster: a fifth of its power more
    ThrusterStarboard,  ///< a fifth
    ThrusterStop,
    LookLeft,   ///< as long as it is held
    LookRight,  ///< as long as it is held
    Acknowledge,
    Bookmark,
    SternThrusterPort,
    SternThrusterStarboard,
    SternThrusterStop,
    PitchAstern,  ///< a tenth of the design pitch
    PitchAhead,   ///< a tenth
    AzimuthPort,  ///< the push of the drives 15 degrees anticlockwise
    AzimuthStarboard
};
inline constexpr int kBridgeActions = static_cast<int>(BridgeAction::AzimuthStarboard) + 1;
QString actionText(BridgeAction action);
/// Name in stored text.
const char* actionName(BridgeAction action);
std::optional<BridgeAction> actionByName(std::string_view name);
/// Actions of telegraph, pitch and azimuth are for one shaft or for all.
bool needsShaft(BridgeAction action);

inline constexpr int kEveryShaft = -1;
inline constexpr int kMostMappedShafts = 4;

struct AxisMap {
    AxisUse use = AxisUse::None;
    int shaft = kEveryShaft;  ///< counted from port, 0 first
    AxisCalibration calibration;
    friend bool operator==(const AxisMap&, const AxisMap&) = default;
};
struct ButtonMap {
    BridgeAction action = BridgeAction::None;
    int shaft = kEveryShaft;
    friend bool operator==(const ButtonMap&, const ButtonMap&) = default;
};
/// Of one kind of device. A hat counts as four buttons behind the others: up, right, down, left.
struct ControlMap {
    std::vector<AxisMap> axes;
    std::vector<ButtonMap> buttons;
    friend bool operator==(const ControlMap&, const ControlMap&) = default;
};

/// For a device nobody has mapped yet: first axis rudder, first button horn, first hat telegraph and look. No
/// axis rings the telegraph unasked.
ControlMap usualMap(int axes, int buttons, int hats);
/// The same map with so many axes and buttons.
ControlMap fitted(ControlMap map, int axes, int buttons);

std::string textOf(const ControlMap& map);
/// Nothing for text that is not a map; unusable calibrations in it become the usual one.
std::optional<ControlMap> controlMapOf(std::string_view text);

}  // namespace sagara::ui
