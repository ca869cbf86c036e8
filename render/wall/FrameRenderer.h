#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/exercise/World.h"
#include "render/link/Messages.h"

namespace sagara::wall {

/// What draws one channel: the scene, or a double in tests. All calls come from the thread that runs the
/// channel.
class FrameRenderer {
public:
    virtual ~FrameRenderer() = default;

    /// Before the first frame, and again when the exercise or the view has changed. The error is for people.
    virtual std::optional<std::string> setup(std::shared_ptr<const core::World> world,
                                             const link::ChannelView& view) = 0;
    /// Draws and does not show. The frame fits the world; its sea is raised.
    virtual void render(const link::Frame& frame) = 0;
    /// Shows what was drawn last. Returns when it is on its way to the screen.
    virtual void show() = 0;
    /// What was shown last. `frame` need not be filled in.
    virtual std::optional<link::Picture> picture() { return std::nullopt; }
    /// Called many times a second while there is nothing to draw: window events. False: the person closed the
    /// window.
    virtual bool idle() { return true; }
};

}  // namespace sagara::wall
