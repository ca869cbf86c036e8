#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/Problems.h"
#include "core/base/Result.h"
#include "render/link/ChannelView.h"

namespace sagara::wall {

inline constexpr int kWallDocumentVersion = 1;
inline constexpr std::size_t kMostChannels = 16;

/// A picture of the wall and the PC that draws it.
struct LayoutChannel {
    link::ChannelView view;
    std::string host = "local";  ///< "local": the station starts it; else for people, who start it there

    bool local() const { return host == "local"; }
};

/// A wall document: which pictures stand side by side.
struct Layout {
    std::string id;
    std::string name;
    std::vector<LayoutChannel> channels;  ///< in the order of the document: from port to starboard
};

/// Every problem at once, each with its path.
core::Result<Layout, core::config::Problems> loadLayout(const std::string& name, std::string_view text);

/// All pictures of another size; fields of view keep their width, their height follows with square pixels.
Layout resized(Layout layout, std::uint32_t width_px, std::uint32_t height_px);
/// Every channel over a whole screen: those of this PC on its screens from left to right, others on the first
/// of theirs.
Layout fullScreen(Layout layout);
/// All channels without a window.
Layout offscreen(Layout layout);

}  // namespace sagara::wall
