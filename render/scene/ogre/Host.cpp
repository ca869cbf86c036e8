#include "render/scene/ogre/Host.h"

#include <OgreLogManager.h>
#include <OgreRenderSystem.h>
#include <OgreRenderWindow.h>
#include <OgreRoot.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/scene/ogre/Screens.h"

namespace sagara::render {

Host::Host() {
    m_log = std::make_unique<Ogre::LogManager>();
    // Nothing to the terminal, nothing to a file: what goes wrong comes as an exception.
    m_log->createLog("sagara", true, false, true);
    m_root = std::make_unique<Ogre::Root>("", "", "");
    try {
        m_root->loadPlugin(SAGARA_OGRE_PLUGINS "/RenderSystem_GL3Plus");
        m_root->setRenderSystem(m_root->getAvailableRenderers().at(0));
        m_root->initialise(false);
        Ogre::NameValuePairList options;
        options["hidden"] = "true";
        options["vsync"] = "false";
        m_root->createRenderWindow("primary", 16, 16, false, &options);
    } catch (const Ogre::Exception& e) {
        // Thrown by the plugin, whose code goes with the root: a copy of the words must outlive it.
        throw std::runtime_error(e.getDescription());
    }
}

Host::~Host() = default;

Ogre::RenderWindow* Host::openWindow(const WindowOptions& o) {
    Ogre::NameValuePairList options;
    options["title"] = o.title;
    options["vsync"] = "false";
    // Never OGRE's own full screen, which may change the mode of the monitor.
    Ogre::RenderWindow* const window = m_root->createRenderWindow(
        o.title, static_cast<unsigned>(o.width), static_cast<unsigned>(o.height), false, &options);
    unsigned w = 0, h = 0, depth = 0;
    int middle = 0, top = 0;  // OGRE puts a window into the middle of the screen
    window->getMetrics(w, h, depth, middle, top);
    const auto screens = screensOf(*window);
    if (o.screen >= static_cast<int>(screens.size()) && o.screen > 0) {
        closeWindow(window);
        throw std::runtime_error("there is no screen " + std::to_string(o.screen) + "; this display has " +
                                 std::to_string(std::max<std::size_t>(1, screens.size())) +
                                 ", counted from 0, left to right");
    }
    const ScreenArea area = screens.empty() ? ScreenArea{0, 0, 2 * middle + o.width, 2 * top + o.height}
                                            : screens[static_cast<std::size_t>(std::max(0, o.screen))];
    if (o.fullScreen) {
        cover(*window, area);
    } else if (o.screen > 0) {
        window->reposition(area.left + std::max(0, area.width - o.width) / 2,
                           area.top + std::max(0, area.height - o.height) / 2);
    } else if (o.aside != 0.0) {
        const int left = middle + static_cast<int>(std::lround(o.aside * o.width));
        window->reposition(std::clamp(left, 0, std::max(0, 2 * middle)), top);
    }
    return window;
}

void Host::closeWindow(Ogre::RenderWindow* window) {
    window->removeAllViewports();
    m_root->getRenderSystem()->destroyRenderWindow(window->getName());
}

}  // namespace sagara::render
