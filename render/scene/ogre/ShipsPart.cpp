#include "render/scene/ogre/ShipsPart.h"

#include <OgreEntity.h>

#include <algorithm>

#include "render/scene/ogre/Axes.h"
#include "render/scene/ogre/Buffers.h"

namespace sagara::render {

namespace {

constexpr double kLidWithin_m = 1000.0;

/// Makes the nodes of ships and what hangs on them; a texture is uploaded once a ship.
class Shipyard {
public:
    Shipyard(const PartContext& context, const ShaderMaterial& solid, const ShaderMaterial& textured)
        : m_context(context),
          m_solid(solid),
          m_textured(textured),
          m_lid(context.materials.make("lid", {.colourWrite = false})) {}

    Ogre::SceneNode* root() { return m_context.scenes.getRootSceneNode()->createChildSceneNode(); }
    Ogre::SceneNode* hang(Ogre::SceneNode* parent, const std::string& name, const Solid& shape,
                          const std::vector<TexturedSolid>& textured) {
        Ogre::SceneNode* node = parent->createChildSceneNode();
        if (!shape.indices.empty()) attach(node, meshOf(name, shape, m_solid.ogre()));
        for (std::size_t i = 0; i < textured.size(); ++i) {
            if (textured[i].solid.indices.empty()) continue;
            const std::string skin = name + "-" + std::to_string(i);
            const auto image = texture(skin, *textured[i].texture);
            const auto material = m_context.materials.withTexture(m_textured, skin, "u_texture", image);
            attach(node, meshOf(skin, textured[i], material.ogre()));
        }
        return node;
    }
    Ogre::SceneNode* lay(Ogre::SceneNode* parent, const std::string& name, const Solid& lid) {
        Ogre::SceneNode* node = parent->createChildSceneNode();
        if (!lid.indices.empty()) attach(node, meshOf(name, lid, m_lid.ogre()), kLidQueue);
        return node;
    }

private:
    void attach(Ogre::SceneNode* node, const Ogre::MeshPtr& mesh, Queue queue = kSolidQueue) {
        auto* entity = m_context.scenes.createEntity(mesh);
        entity->setRenderQueueGroup(queue);
        node->attachObject(entity);
    }

    const PartContext& m_context;
    const ShaderMaterial& m_solid;
    const ShaderMaterial& m_textured;
    ShaderMaterial m_lid;
};

}  // namespace

ShipsPart::ShipsPart(const PartContext& context, const ShaderMaterial& solid, const ShaderMaterial& textured)
    : m_detailWithin_m(context.figures.detailWithin_m) {
    Shipyard yard(context, solid, textured);
    const auto build = [&](const std::string& name, const ShipShape& shape) {
        Ship ship;
        ship.node = yard.root();
        ship.hull = yard.hang(ship.node, name + "-hull", shape.hull, shape.textured.hull);
        ship.upperworks =
            yard.hang(ship.node, name + "-upperworks", shape.upperworks, shape.textured.upperworks);
        ship.detail = yard.hang(ship.node, name + "-detail", shape.detail, shape.textured.detail);
        ship.lid = yard.lay(ship.node, name + "-lid", shape.lid);
        return ship;
    };
    for (std::size_t i = 0; i < context.fleet.own.size(); ++i)
        m_own.push_back(build("own-" + std::to_string(i), context.fleet.own[i].shape));
    for (std::size_t i = 0; i < context.fleet.targets.size(); ++i)
        m_targets.push_back(build("target-" + std::to_string(i), context.fleet.targets[i].shape));
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
