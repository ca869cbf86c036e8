#include "render/scene/ogre/Host.h"

#include <OgreLogManager.h>
#include <OgreRenderSystem.h>
#include <OgreRenderWindow.h>
#include <OgreRoot.h>

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

Ogre::RenderWindow* Host::openWindow(const std::string& title, int width, int height, bool fullScreen) {
    Ogre::NameValuePairList options;
    options["title"] = title;
    options["vsync"] = "false";
    return m_root->createRenderWindow(title, static_cast<unsigned>(width), static_cast<unsigned>(height),
                                      fullScreen, &options);
}

void Host::closeWindow(Ogre::RenderWindow* window) {
    window->removeAllViewports();
    m_root->getRenderSystem()->destroyRenderWindow(window->getName());
}

}  // namespace sagara::render
