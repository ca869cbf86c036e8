#pragma once

#include "render/link/Connection.h"

namespace sagara::link {

/// What each side is ready to hear, phase by phase.
inline constexpr KindSet kBeforeGreeting{Kind::Greeting, Kind::Refused};
inline constexpr KindSet kBeforeWelcome{Kind::Welcome, Kind::Refused};
inline constexpr KindSet kFromStation{Kind::Setup, Kind::Frame,   Kind::Show,
                                      Kind::Ping,  Kind::Refused, Kind::Bye};
inline constexpr KindSet kBeforeHello{Kind::Hello};
inline constexpr KindSet kFromChannel{Kind::Ready, Kind::Rendered, Kind::Shown,
                                      Kind::Pong,  Kind::Refused,  Kind::Bye};
inline constexpr KindSet kFromChannelWithPicture{Kind::Ready,   Kind::Rendered, Kind::Shown, Kind::Pong,
                                                 Kind::Picture, Kind::Refused,  Kind::Bye};

/// Who a channel says it is.
struct Introduction {
    Role role = Role::View;
    std::string channel;
    std::string token;  ///< empty on the station's own PC
};

/// Channel side, up to the welcome. The error is for people.
core::Result<ChannelView, std::string> introduce(Connection& connection, const Introduction& who,
                                                 int patience_ms);

/// Station side: how it greets, and what speaks against a hello as such. Whether the layout has such a
/// channel and it is free is for the wall to judge.
Greeting greeting();
std::optional<std::string> objectionTo(const Hello& hello, const Nonce& nonce, const std::string& token);

}  // namespace sagara::link
