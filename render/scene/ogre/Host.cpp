#include "render/scene/ogre/Host.h"

#include <OgreLogManager.h>
#include <OgreRenderSystem.h>
#include <OgreRenderWindow.h>
#include <OgreRoot.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

Ogre::RenderWindow* Host::openWindow(const std::string& title, int width, int height, bool fullScreen,
                                     double aside) {
    Ogre::NameValuePairList options;
    options["title"] = title;
    options["vsync"] = "false";
    Ogre::RenderWindow* const window = m_root->createRenderWindow(
        title, static_cast<unsigned>(width), static_cast<unsigned>(height), fullScreen, &options);
    unsigned w = 0, h = 0, depth = 0;
    int middle = 0, top = 0;  // OGRE puts a window into the middle of the screen
    window->getMetrics(w, h, depth, middle, top);
    const int left = middle + static_cast<int>(std::lround(aside * width));
    if (!fullScreen && aside != 0.0) window->reposition(std::clamp(left, 0, std::max(0, 2 * middle)), top);
    return window;
}

void Host::closeWindow(Ogre::RenderWindow* window) {
    window->removeAllViewports();
    m_root->getRenderSystem()->destroyRenderWindow(window->getName());
}

}  // namespace sagara::render
