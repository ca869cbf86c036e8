#include "render/scene/ogre/ViewTarget.h"

#include <OgreHardwarePixelBuffer.h>
#include <OgreRenderTexture.h>
#include <OgreResourceGroupManager.h>
#include <OgreRoot.h>
#include <OgreTextureManager.h>
#include <OgreViewport.h>

#include <algorithm>

#include "render/scene/ogre/Axes.h"
#include "render/scene/ogre/WindowEvents.h"

namespace sagara::render {
namespace {

constexpr float kNear_m = 1.0f;
constexpr float kFar_m = 60'000.0f;

std::string newName(const char* what) {
    static int count = 0;
    return what + std::to_string(++count);
}

}  // namespace

void ViewportState::resize(int width, int height) {
    const std::lock_guard lock(m_mutex);
    m_width = std::max(1, width);
    m_height = std::max(1, height);
}
void ViewportState::setCamera(const Camera& camera) {
    const std::lock_guard lock(m_mutex);
    m_camera = camera;
}
std::shared_ptr<const Picture> ViewportState::latest() const {
    const std::lock_guard lock(m_mutex);
    return m_latest;
}
Viewport::Size ViewportState::size() const {
    const std::lock_guard lock(m_mutex);
    return m_size;
}
DrawFigures ViewportState::figures() const {
    const std::lock_guard lock(m_mutex);
    return m_figures;
}
std::string ViewportState::trouble() const {
    const std::lock_guard lock(m_mutex);
    return m_trouble;
}
void ViewportState::setTrouble(std::string trouble) {
    const std::lock_guard lock(m_mutex);
    m_trouble = std::move(trouble);
}
ViewportState::Wanted ViewportState::wanted() const {
    const std::lock_guard lock(m_mutex);
    return {m_width, m_height, m_camera};
}
void ViewportState::finish(std::shared_ptr<const Picture> picture, Size size, DrawFigures figures) {
    const std::lock_guard lock(m_mutex);
    m_size = size;
    m_latest = std::move(picture);
    m_figures = figures;
}

ViewTarget::ViewTarget(Host& host, std::shared_ptr<ViewportState> state, Ogre::RenderWindow* window,
                       bool readBack)
    : m_host(host), m_state(std::move(state)), m_window(window), m_readBack(readBack || window == nullptr) {
    if (m_window != nullptr) {
        m_window->setAutoUpdated(false);
        m_target = m_window;
    }
}

ViewTarget::~ViewTarget() {
    forget();
    if (m_window != nullptr) m_host.closeWindow(m_window);
}

void ViewTarget::forget() {
    if (m_target != nullptr) m_target->removeAllViewports();
    if (m_texture) Ogre::TextureManager::getSingleton().remove(m_texture);
    m_texture.reset();
    if (m_window == nullptr) m_target = nullptr;
    m_camera = nullptr;  // the scene manager owns it
    m_node = nullptr;
}

void ViewTarget::fit(Scene& scene, int width, int height) {
    if (m_camera == nullptr) {
        m_camera = scene.scenes().createCamera(newName("camera"));
        m_camera->setNearClipDistance(kNear_m);
        m_camera->setFarClipDistance(kFar_m);
        m_node = scene.scenes().getRootSceneNode()->createChildSceneNode();
        m_node->attachObject(m_camera);
    }
    if (m_window == nullptr && (!m_texture || static_cast<int>(m_texture->getWidth()) != width ||
                                static_cast<int>(m_texture->getHeight()) != height)) {
        if (m_target != nullptr) m_target->removeAllViewports();
        if (m_texture) Ogre::TextureManager::getSingleton().remove(m_texture);
        m_texture = Ogre::TextureManager::getSingleton().createManual(
            newName("view"), Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, static_cast<unsigned>(width),
            static_cast<unsigned>(height), 0, Ogre::PF_A8R8G8B8, Ogre::TU_RENDERTARGET);
        m_target = m_texture->getBuffer()->getRenderTarget();
        m_target->setAutoUpdated(false);
    }
    if (m_target->getNumViewports() == 0) {
        Ogre::Viewport* viewport = m_target->addViewport(m_camera);
        viewport->setOverlaysEnabled(false);
        viewport->setShadowsEnabled(false);
        viewport->setClearEveryFrame(true, Ogre::FBT_COLOUR | Ogre::FBT_DEPTH);
        viewport->setBackgroundColour(Ogre::ColourValue(0.25f, 0.5f, 0.75f));
    }
}

void ViewTarget::aim(const Camera& camera) {
    m_node->setOrientation(ogreAttitude(camera));
    const auto edge = [](double tangent) { return static_cast<float>(tangent) * kNear_m; };
    m_camera->setFrustumExtents(edge(camera.lens.left), edge(camera.lens.right), edge(camera.lens.up),
                                edge(camera.lens.down));
}

void ViewTarget::draw(Scene& scene) {
    if (m_window != nullptr && pumpWindow(*m_window)) m_state->close();
    ViewportState::Wanted wanted = m_state->wanted();
    if (m_window != nullptr) {
        wanted.width = static_cast<int>(m_window->getWidth());
        wanted.height = static_cast<int>(m_window->getHeight());
    }
    fit(scene, wanted.width, wanted.height);
    aim(wanted.camera);
    scene.look(wanted.camera, wanted.width, wanted.height);
    m_target->update(false);
    const Ogre::RenderTarget::FrameStats& stats = m_target->getStatistics();
    m_state->finish(m_readBack ? readBack() : nullptr, {wanted.width, wanted.height},
                    {stats.triangleCount, stats.batchCount});
}

std::shared_ptr<const Picture> ViewTarget::readBack() {
    // One that nobody looks at any more, if there is one: fresh memory for every frame costs a millisecond.
    auto free =
        std::find_if(m_pictures.begin(), m_pictures.end(), [](const auto& p) { return p.use_count() == 1; });
    if (free == m_pictures.end()) free = m_pictures.insert(m_pictures.end(), std::make_shared<Picture>());
    const std::shared_ptr<Picture> picture = *free;
    picture->width = static_cast<int>(m_target->getWidth());
    picture->height = static_cast<int>(m_target->getHeight());
    picture->bgra.resize(4 * static_cast<std::size_t>(picture->width) *
                         static_cast<std::size_t>(picture->height));
    const Ogre::PixelBox box(m_target->getWidth(), m_target->getHeight(), 1, Ogre::PF_A8R8G8B8,
                             picture->bgra.data());
    m_target->copyContentsToMemory(box, box);
    return picture;
}

void ViewTarget::present() {
    if (m_window != nullptr) m_window->swapBuffers();
}

}  // namespace sagara::render
