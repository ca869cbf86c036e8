#include "render/scene/ogre/LandPart.h"

#include <OgreEntity.h>

#include <string>

#include "render/scene/land/Buildings.h"
#include "render/scene/land/LandMesh.h"
#include "render/scene/ogre/Axes.h"
#include "render/scene/ogre/Buffers.h"

namespace sagara::render {

LandPart::LandPart(const PartContext& context, const ShaderMaterial& solid)
    : m_node(context.scenes.getRootSceneNode()->createChildSceneNode()) {
    const core::Area& area = context.world.area;
    const Ground ground(area);
    std::vector<Solid> solids = landMesh(area, ground);
    for (Solid& s : buildings(area, ground, context.figures)) solids.push_back(std::move(s));
    solids.push_back(distantCoast(area));
    int count = 0;
    for (const Solid& s : solids) {
        if (s.indices.empty()) continue;
        auto* entity =
            context.scenes.createEntity(meshOf("land-" + std::to_string(count++), s, solid.ogre()));
        entity->setRenderQueueGroup(kSolidQueue);
        // A node of its own: OGRE leaves out nodes, not what hangs on them.
        m_node->createChildSceneNode()->attachObject(entity);
    }
}

void LandPart::advance(const Frame& frame) {
    m_waterAboveMean_m = frame.moment.tide_m - frame.world.area.meanTideLevel_m;
}

void LandPart::look(const Frame&, const View& view) {
    m_node->setPosition(relativeTo(view.camera, {0.0, 0.0}, -m_waterAboveMean_m));
}

}  // namespace sagara::render
