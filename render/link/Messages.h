#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "core/exercise/Snapshot.h"
#include "render/link/ChannelView.h"

/// What is said on the link, as values. The station greets, the channel says hello and is welcomed or
/// refused; then the station sends the exercise once and frame after frame.
namespace sagara::link {

enum class Role : std::uint8_t {
    View,     ///< a picture of the wall; the wall waits for it
    Console,  ///< sends commands
    Observer  ///< gets what views get, as fast as it can; nobody waits for it
};

using Nonce = std::array<std::byte, 16>;
using Proof = std::array<std::byte, 32>;

struct Greeting {
    std::vector<std::uint32_t> speaks;  ///< protocol versions
    Nonce nonce{};
    std::string build;  ///< of core; bit-equal seas are promised between equal builds only
};

struct Hello {
    Role role = Role::View;
    std::string channel;  ///< name in the layout
    Proof proof{};        ///< that the shared token is known; see Token.h
    std::string build;
    std::uint32_t process = 0;
};

struct Refused {
    std::string reason;
    std::vector<std::uint32_t> speaks;
};

struct Welcome {
    ChannelView view;
};

/// The exercise: a channel builds the same World from it.
struct Setup {
    core::ExerciseDocuments documents;
    std::uint64_t seed = 0;
};

/// The channel has built the world and can draw.
struct Ready {};

/// Longer lists are refused.
inline constexpr std::size_t kMostShips = 16;
inline constexpr std::size_t kMostTargets = 512;

/// One moment to be drawn by all channels. Of the snapshot these travel: tick, level, weather, wind, sea
/// systems, tide, targets, and of own ships what can be seen; not orders, autopilot, tasks and score.
/// `snapshot.sea.active` is empty after decoding: raise the sea with core::raiseSea.
struct Frame {
    std::uint64_t number = 0;
    core::SimTime time;  ///< poses are of this moment, sea and lights must be drawn for it
    core::Snapshot snapshot;
};

struct Rendered {
    std::uint64_t frame = 0;
    std::uint32_t took_us = 0;
};
struct Show {
    std::uint64_t frame = 0;
    bool picture = false;  ///< send it back as well
};
struct Shown {
    std::uint64_t frame = 0;
    std::int64_t at_us = 0;  ///< clock of the channel
};

/// Clocks are those of the sender or answerer: steady, of any origin.
struct Ping {
    std::uint64_t id = 0;
    std::int64_t sent_us = 0;
};
struct Pong {
    std::uint64_t id = 0;
    std::int64_t sent_us = 0;
    std::int64_t received_us = 0;
    std::int64_t answered_us = 0;
};

struct Picture {
    std::uint64_t frame = 0;
    std::uint32_t width_px = 0;
    std::uint32_t height_px = 0;
    std::vector<std::byte> bgra;  ///< rows from the top, 4 bytes a pixel
};

struct Bye {
    std::string reason;
};

using Message = std::variant<Greeting, Hello, Refused, Welcome, Setup, Ready, Frame, Rendered, Show, Shown,
                             Ping, Pong, Picture, Bye>;

}  // namespace sagara::link
