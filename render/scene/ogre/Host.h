#pragma once

#include <OgrePrerequisites.h>

#include <filesystem>
#include <memory>
#include <string>

#include "render/scene/Stage.h"

namespace sagara::render {

/// OGRE itself: root, GL3Plus, and the hidden primary window, which must be the first and outlive all others.
/// One of a process; made, used and destroyed on the render thread. The constructor throws
/// std::runtime_error.
class Host {
public:
    Host();
    ~Host();
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    Ogre::Root& root() { return *m_root; }
    /// Throws std::runtime_error when there is no such screen.
    Ogre::RenderWindow* openWindow(const WindowOptions& options);
    void closeWindow(Ogre::RenderWindow* window);

private:
    std::unique_ptr<Ogre::LogManager> m_log;
    std::unique_ptr<Ogre::Root> m_root;
};

}  // namespace sagara::render
