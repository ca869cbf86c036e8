#pragma once

#include <OgrePrerequisites.h>

namespace sagara::render {

/// Takes what the X server has sent to a window: a new size is passed to OGRE, and true means a person wants
/// it closed. OGRE's own pump is in a library that links libX11, which the headless stand-in must come
/// before; so libX11 is loaded here when there is a window.
bool pumpWindow(Ogre::RenderWindow& window);

}  // namespace sagara::render
