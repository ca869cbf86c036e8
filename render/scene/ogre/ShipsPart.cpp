#include "render/scene/ogre/ShipsPart.h"

#include <OgreEntity.h>

#include "render/scene/ogre/Axes.h"
#include "render/scene/ogre/Buffers.h"
#include "render/scene/ship/ShipShape.h"

namespace sagara::render {

ShipsPart::ShipsPart(const PartContext& context, const ShaderMaterial& solid)
    : m_detailWithin_m(context.figures.detailWithin_m) {
    const auto hang = [&](Ogre::SceneNode* parent, const std::string& name, const Solid& shape) {
        Ogre::SceneNode* node = parent->createChildSceneNode();
        if (shape.indices.empty()) return node;
        auto* entity = context.scenes.createEntity(meshOf(name, shape, solid.ogre()));
        entity->setRenderQueueGroup(kSolidQueue);
        node->attachObject(entity);
        return node;
    };
    const auto build = [&](const std::string& name, const ShipForm& form, unsigned variant) {
        const ShipShape shape = shapeOf(form, variant);
        Ship ship;
        ship.node = context.scenes.getRootSceneNode()->createChildSceneNode();
        ship.hull = hang(ship.node, name + "-hull", shape.hull);
        ship.upperworks = hang(ship.node, name + "-upperworks", shape.upperworks);
        ship.detail = hang(ship.node, name + "-detail", shape.detail);
        return ship;
    };
    for (std::size_t i = 0; i < context.world.ships.size(); ++i)
        m_own.push_back(build("own-" + std::to_string(i), formOf(context.world.ships[i]->vessel), 0));
    for (std::size_t i = 0; i < context.world.targets.size(); ++i)
        m_targets.push_back(
            build("target-" + std::to_string(i), formOf(context.world.targets[i]), static_cast<unsigned>(i)));
}

void ShipsPart::advance(const Frame&) {}

void ShipsPart::place(const Ship& ship, const ShipPose& pose, const View& view, bool inside) const {
    ship.node->setVisible(true);
    ship.node->setPosition(relativeTo(view.camera, pose.position, -pose.down_m));
    ship.node->setOrientation(ogreAttitude(pose.heading_rad, pose.pitch_rad, pose.roll_rad));
    ship.upperworks->setVisible(!inside);
    const double away_m = core::distance(pose.position, view.camera.position);
    ship.detail->setVisible(away_m < m_detailWithin_m);
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
