#pragma once

#include <OgrePrerequisites.h>

#include <vector>

namespace sagara::render {

/// A monitor or projector, as the X server has it laid out.
struct ScreenArea {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
};

/// Of the window's display, from left to right, then from top to bottom; none when the X server does not tell
/// (no XRandR 1.5, or no X server at all).
std::vector<ScreenArea> screensOf(Ogre::RenderWindow& window);

/// Lays the window over the whole screen, without a frame: by itself, and by asking the window manager if
/// there is one.
void cover(Ogre::RenderWindow& window, const ScreenArea& screen);

}  // namespace sagara::render
