#pragma once

#include <OgreCamera.h>
#include <OgreRenderWindow.h>
#include <OgreTexture.h>

#include <atomic>
#include <mutex>

#include "render/scene/Stage.h"
#include "render/scene/ogre/Scene.h"

namespace sagara::render {

/// What viewport and render thread share of one viewport.
class ViewportState final : public Viewport {
public:
    ViewportState(int width, int height) : m_width(width), m_height(height) {}

    void resize(int width, int height) override;
    void setCamera(const Camera& camera) override;
    std::shared_ptr<const Picture> latest() const override;
    Size size() const override;
    DrawFigures figures() const override;
    bool closed() const override { return m_closed; }
    std::string trouble() const override;

    struct Wanted {
        int width;
        int height;
        Camera camera;
    };
    Wanted wanted() const;
    void finish(std::shared_ptr<const Picture> picture, Size size, DrawFigures figures);
    void close() { m_closed = true; }
    void setTrouble(std::string trouble);

private:
    mutable std::mutex m_mutex;
    int m_width;
    int m_height;
    Camera m_camera;
    std::shared_ptr<const Picture> m_latest;
    Size m_size;
    DrawFigures m_figures;
    std::string m_trouble;
    std::atomic<bool> m_closed = false;
};

/// The render thread's side of a viewport: an OGRE camera and the texture or window it draws to.
class ViewTarget {
public:
    /// `window` null: a texture, read back after each frame.
    ViewTarget(Host& host, std::shared_ptr<ViewportState> state, Ogre::RenderWindow* window, bool readBack);
    ~ViewTarget();

    void draw(Scene& scene);
    void present();
    void forget();  ///< the scene goes
    const std::shared_ptr<ViewportState>& state() const { return m_state; }

private:
    void fit(Scene& scene, int width, int height);
    void aim(const Camera& camera);
    std::shared_ptr<const Picture> readBack();

    Host& m_host;
    std::shared_ptr<ViewportState> m_state;
    Ogre::RenderWindow* m_window;
    bool m_readBack;
    std::vector<std::shared_ptr<Picture>> m_pictures;  ///< for reading back
    Ogre::TexturePtr m_texture;
    Ogre::RenderTarget* m_target = nullptr;
    Ogre::Camera* m_camera = nullptr;
    Ogre::SceneNode* m_node = nullptr;
};

}  // namespace sagara::render
