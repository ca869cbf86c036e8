#pragma once

#include <string>

#include "render/scene/Stage.h"
#include "render/wall/ChannelClient.h"

namespace sagara::view {

struct ChannelRequest {
    wall::ChannelOptions station;
    bool fullScreen = false;
    std::optional<int> screen;  ///< instead of the layout's
    int width = 0;              ///< of the window; 0: as the layout says
    int height = 0;
};

/// "HOST:PORT", also "[::1]:PORT". False when it is not that.
bool parseStation(const std::string& text, wall::ChannelOptions& station);

/// Draws one channel of a wall until the station ends it. Returns the exit code.
int runChannel(const render::StageOptions& stage, const ChannelRequest& request);

}  // namespace sagara::view
