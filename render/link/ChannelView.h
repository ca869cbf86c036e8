#pragma once

#include <cstdint>
#include <string>

namespace sagara::link {

/// Where a channel looks from, relative to the bridge eye of her ship. Frame B, but up is positive.
struct EyePoint {
    double forward_m = 0.0;
    double starboard_m = 0.0;
    double up_m = 0.0;
    friend bool operator==(const EyePoint&, const EyePoint&) = default;
};

/// Tangents of the angles between the axis and the edges of the picture, each counted outwards. Off axis when
/// left and right, or down and up, differ. The axis stays level: a pitched camera would make channels meet at
/// an angle.
struct Frustum {
    double left = 0.5;
    double right = 0.5;
    double down = 0.28;
    double up = 0.28;
    friend bool operator==(const Frustum&, const Frustum&) = default;
};

enum class Output : std::uint8_t { Window, Fullscreen, Offscreen };

/// One picture of a wall: what its channel must know to draw it.
struct ChannelView {
    std::string name;
    std::uint32_t ship = 0;  ///< own ship it looks from
    EyePoint eye;
    double yaw_rad = 0.0;  ///< of the axis from the bow, to starboard positive
    Frustum frustum;
    std::uint32_t width_px = 1280;
    std::uint32_t height_px = 720;
    Output output = Output::Window;
    std::uint32_t screen = 0;  ///< monitor of its PC the window opens on: 0 is the leftmost
    friend bool operator==(const ChannelView&, const ChannelView&) = default;
};

inline constexpr std::uint32_t kMostPixelsAcross = 4096;
inline constexpr std::uint32_t kMostScreens = 16;

}  // namespace sagara::link
