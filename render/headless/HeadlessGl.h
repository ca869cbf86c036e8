#pragma once

#include <optional>
#include <string>

namespace sagara::render {

/// Puts the EGL stand-in for Xlib and GLX before the real ones, for everything loaded later in this process.
/// Call it once before OGRE loads its render system; there is no way back. Returns why it could not.
std::optional<std::string> useHeadlessGl();

/// Whether an X display can be hoped for: DISPLAY is set.
bool displayIsSet();

}  // namespace sagara::render
