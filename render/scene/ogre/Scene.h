#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "render/scene/ogre/Host.h"
#include "render/scene/ogre/Part.h"

namespace sagara::render {

/// The picture of one exercise: all its parts and their resources. Made and used on the render thread; a new
/// exercise is a new scene.
class Scene {
public:
    Scene(Host& host, std::shared_ptr<const core::World> world, const std::filesystem::path& assets,
          Preset preset, const std::filesystem::path& ownModels = {});
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    Ogre::SceneManager& scenes() { return *m_scenes; }
    const std::vector<std::string>& remarks() const { return m_fleet.remarks; }
    void advance(const Moment& moment);
    /// Puts everything where this view's eye sees it. After `advance`.
    void look(const Camera& camera, int width, int height);

private:
    void takeIn(const std::vector<core::TargetLayout>& added);

    Host& m_host;
    std::shared_ptr<const core::World> m_world;
    PresetFigures m_figures;
    Ogre::SceneManager* m_scenes;
    Fleet m_fleet;
    std::vector<core::TargetLayout> m_added;  ///< those at the end of m_fleet.targets
    std::unique_ptr<Materials> m_materials;
    std::vector<std::unique_ptr<Part>> m_parts;
    Moment m_moment;
    SkyLight m_light;
};

}  // namespace sagara::render
