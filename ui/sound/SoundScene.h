#pragma once

#include <vector>

#include "core/exercise/Snapshot.h"

namespace sagara::ui {

/// A place seen from the own ship: frame B of the level ship, and height above the water.
struct SoundPlace {
    double forward_m = 0.0;
    double starboard_m = 0.0;
    double up_m = 0.0;
};

/// What is to be heard at one moment, on one ship. Plain data; SoundBoard makes it sound.
struct SoundScene {
    struct Engine {
        double shaft_rpm = 0.0;  ///< negative astern
        double firing_Hz = 0.0;  ///< 0: stands still
        double load = 0.0;       ///< 0 to 1
        bool turning = false;
    };
    std::vector<Engine> engines;  ///< port to starboard
    SoundPlace enginesAt;
    double wash = 0.0;       ///< of the propellers, 0 to 1
    double blades_Hz = 0.0;  ///< at which they beat
    SoundPlace washAt;
    double bowWave = 0.0;    ///< 0 to 1
    double speed_mps = 0.0;  ///< through the water
    SoundPlace bowAt;
    double wind = 0.0;           ///< over the deck, 0 to 1
    double windSpeed_mps = 0.0;  ///< over the deck
    double windFrom_rad = 0.0;   ///< from the bow, clockwise
    double rain = 0.0;           ///< 0 to 1
    bool horn = false;
    double hornPitch_Hz = 220.0;
    SoundPlace hornAt;
    bool bell = false;
    double cableLinks_Hz = 0.0;  ///< links over the gipsy a second
    SoundPlace forecastle;
    bool alarm = false;

    /// Another ship that sounds.
    struct Other {
        std::size_t id = 0;  ///< the same ship at every moment
        SoundPlace at;
        double pitch_Hz = 220.0;
        bool horn = false, bell = false, gong = false;
    };
    std::vector<Other> others;  ///< nearest first, at most kMostHeard

    struct Listener {
        SoundPlace at;
        double look_rad = 0.0;  ///< clockwise from the bow
        bool outside = false;   ///< on the wing, or doors open
    } listener;
};
inline constexpr std::size_t kMostHeard = 6;

/// What the bridge does that the simulation does not know of.
struct BridgeSounds {
    bool horn = false;
    bool bell = false;
    bool alarm = false;
    double look_rad = 0.0;
    bool outside = false;
};

/// Total for any snapshot of this world; a ship that is not there hears nothing. Signals of other ships
/// arrive late by the way they have: their rule is a function of time, so it is asked for the time they left.
SoundScene soundSceneOf(const core::World& world, const core::Snapshot& now, const BridgeSounds& bridge,
                        std::size_t ship = 0);

}  // namespace sagara::ui
