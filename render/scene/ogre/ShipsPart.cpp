#include "render/scene/ogre/ShipsPart.h"

#include <OgreEntity.h>

#include <algorithm>

#include "render/scene/ogre/Axes.h"
#include "render/scene/ogre/Buffers.h"

namespace sagara::render {

namespace {

constexpr double kLidWithin_m = 1000.0;

/// Makes the nodes of a ship and what hangs on them; a texture is uploaded once a ship.
class Shipyard {
public:
    Shipyard(Ogre::SceneManager& scenes, Materials& materials) : m_scenes(scenes), m_materials(materials) {}

    Ogre::SceneNode* root() { return m_scenes.getRootSceneNode()->createChildSceneNode(); }
    Ogre::SceneNode* hang(Ogre::SceneNode* parent, const std::string& name, const Solid& shape,
                          const ShaderMaterial& solid, const std::vector<TexturedSolid>& textured,
                          const ShaderMaterial& skinned) {
        Ogre::SceneNode* node = parent->createChildSceneNode();
        if (!shape.indices.empty()) attach(node, meshOf(name, shape, solid.ogre()));
        for (std::size_t i = 0; i < textured.size(); ++i) {
            if (textured[i].solid.indices.empty()) continue;
            const std::string skin = name + "-" + std::to_string(i);
            const auto image = texture(skin, *textured[i].texture);
            const auto material = m_materials.withTexture(skinned, skin, "u_texture", image);
            attach(node, meshOf(skin, textured[i], material.ogre()));
        }
        return node;
    }
    Ogre::SceneNode* lay(Ogre::SceneNode* parent, const std::string& name, const Solid& shape,
                         const ShaderMaterial& lid) {
        Ogre::SceneNode* node = parent->createChildSceneNode();
        if (!shape.indices.empty()) attach(node, meshOf(name, shape, lid.ogre()), kLidQueue);
        return node;
    }

private:
    void attach(Ogre::SceneNode* node, const Ogre::MeshPtr& mesh, Queue queue = kSolidQueue) {
        auto* entity = m_scenes.createEntity(mesh);
        entity->setRenderQueueGroup(queue);
        node->attachObject(entity);
    }

    Ogre::SceneManager& m_scenes;
    Materials& m_materials;
};

}  // namespace

ShipsPart::ShipsPart(const PartContext& context, const ShaderMaterial& solid, const ShaderMaterial& textured)
    : m_scenes(context.scenes),
      m_materials(context.materials),
      m_solid(solid),
      m_textured(textured),
      m_lid(context.materials.make("lid", {.colourWrite = false})),
      m_detailWithin_m(context.figures.detailWithin_m) {
    for (std::size_t i = 0; i < context.fleet.own.size(); ++i)
        m_own.push_back(build("own-" + std::to_string(i), context.fleet.own[i].shape));
    for (std::size_t i = 0; i < context.fleet.targets.size(); ++i)
        m_targets.push_back(build("target-" + std::to_string(i), context.fleet.targets[i].shape));
}

ShipsPart::Ship ShipsPart::build(const std::string& name, const ShipShape& shape) {
    Shipyard yard(m_scenes, m_materials);
    Ship ship;
    ship.node = yard.root();
    ship.hull = yard.hang(ship.node, name + "-hull", shape.hull, m_solid, shape.textured.hull, m_textured);
    ship.upperworks = yard.hang(ship.node, name + "-upperworks", shape.upperworks, m_solid,
                                shape.textured.upperworks, m_textured);
    ship.detail =
        yard.hang(ship.node, name + "-detail", shape.detail, m_solid, shape.textured.detail, m_textured);
    ship.lid = yard.lay(ship.node, name + "-lid", shape.lid, m_lid);
    return ship;
}

void ShipsPart::join(const Fleet& fleet, std::size_t fromTarget) {
    // Who is no longer there is only hidden: it is rare, and her meshes go with the scene.
    for (std::size_t i = fromTarget; i < m_targets.size(); ++i) m_targets[i].node->setVisible(false);
    m_targets.resize(fromTarget);
    for (std::size_t i = fromTarget; i < fleet.targets.size(); ++i)
        m_targets.push_back(build("added-" + std::to_string(++m_joined), fleet.targets[i].shape));
}

void ShipsPart::advance(const Frame&) {}

void ShipsPart::place(const Ship& ship, const ShipPose& pose, const View& view, bool inside) const {
    ship.node->setVisible(true);
    ship.node->setPosition(relativeTo(view.camera, pose.position, -pose.down_m));
    ship.node->setOrientation(ogreAttitude(pose.heading_rad, pose.pitch_rad, pose.roll_rad));
    ship.upperworks->setVisible(!inside);
    const double away_m = core::distance(pose.position, view.camera.position);
    // Thinner than a pixel beyond that.
    ship.detail->setVisible(away_m < m_detailWithin_m * std::min(1.0, view.height / 720.0));
    ship.lid->setVisible(away_m < kLidWithin_m);
}

void ShipsPart::look(const Frame& frame, const View& view) {
    for (const auto* list : {&m_own, &m_targets})
        for (const Ship& ship : *list) ship.node->setVisible(false);
    for (std::size_t i = 0; i < std::min(m_own.size(), frame.moment.ships.size()); ++i)
        place(m_own[i], frame.moment.ships[i], view, view.camera.inside == i);
    for (const TargetPose& target : frame.moment.targets)
        if (target.index < m_targets.size()) place(m_targets[target.index], target, view, false);
}

}  // namespace sagara::render
