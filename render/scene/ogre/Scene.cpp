#include "render/scene/ogre/Scene.h"

#include <OgreResourceGroupManager.h>
#include <OgreRoot.h>

#include <algorithm>

#include "render/scene/ogre/DayShapesPart.h"
#include "render/scene/ogre/LandPart.h"
#include "render/scene/ogre/LightsPart.h"
#include "render/scene/ogre/LinesPart.h"
#include "render/scene/ogre/RainPart.h"
#include "render/scene/ogre/SeaPart.h"
#include "render/scene/ogre/ShipsPart.h"
#include "render/scene/ogre/SkyPart.h"
#include "render/scene/ogre/StarsPart.h"
#include "render/scene/ogre/WakePart.h"

namespace sagara::render {

Scene::Scene(Host& host, std::shared_ptr<const core::World> world, const std::filesystem::path& assets,
             Preset preset, const std::filesystem::path& ownModels)
    : m_host(host),
      m_world(std::move(world)),
      m_figures(figuresOf(preset)),
      m_scenes(host.root().createSceneManager()),
      m_fleet(fleetOf(*m_world, assets, ownModels)) {
    Ogre::ResourceGroupManager::getSingleton().createResourceGroup(kSceneGroup);
    m_materials = std::make_unique<Materials>(assets / "shaders", m_figures);
    const PartContext context{*m_world, *m_scenes, *m_materials, m_figures, m_fleet};
    m_parts.push_back(std::make_unique<SkyPart>(context));
    auto ownSea = std::make_unique<SeaPart>(context);
    SeaPart& sea = *ownSea;
    m_parts.push_back(std::move(ownSea));
    const ShaderMaterial solid = m_materials->make("solid");
    m_parts.push_back(std::make_unique<ShipsPart>(context, solid, m_materials->make("textured")));
    m_parts.push_back(std::make_unique<LandPart>(context, solid));
    m_parts.push_back(std::make_unique<LightsPart>(context, solid, sea));
    m_parts.push_back(std::make_unique<DayShapesPart>(context, solid));
    m_parts.push_back(std::make_unique<LinesPart>(context));
    m_parts.push_back(std::make_unique<StarsPart>(context));
    m_parts.push_back(std::make_unique<WakePart>(context, sea));
    m_parts.push_back(std::make_unique<RainPart>(context));
}

Scene::~Scene() {
    m_parts.clear();
    m_materials.reset();
    m_host.root().destroySceneManager(m_scenes);
    Ogre::ResourceGroupManager::getSingleton().destroyResourceGroup(kSceneGroup);
}

void Scene::takeIn(const std::vector<core::TargetLayout>& added) {
    // Those that stay the same stay; who went back in time may find others in their place.
    const auto differ = std::mismatch(m_added.begin(), m_added.end(), added.begin(), added.end(), looksLike);
    if (differ.second == added.end()) return;
    const auto from = m_world->targets.size() + static_cast<std::size_t>(differ.second - added.begin());
    m_fleet.targets.resize(from);
    m_added.erase(differ.first, m_added.end());
    for (auto it = differ.second; it != added.end(); ++it) {
        m_fleet.targets.push_back(lookOfAdded(*it, m_fleet.targets.size()));
        m_added.push_back(*it);
    }
    for (const auto& part : m_parts) part->join(m_fleet, from);
}

void Scene::advance(const Moment& moment) {
    takeIn(moment.added);
    m_moment = moment;
    m_light = skyLight(*m_world, m_moment);
    const Frame frame{*m_world, m_moment, m_light};
    for (const auto& part : m_parts) part->advance(frame);
}

void Scene::look(const Camera& camera, int width, int height) {
    const Frame frame{*m_world, m_moment, m_light};
    for (const auto& part : m_parts) part->look(frame, {camera, width, height});
}

}  // namespace sagara::render
