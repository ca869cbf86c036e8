#include "render/scene/ogre/WakePart.h"

#include <iterator>
#include <utility>

#include "render/scene/ogre/Axes.h"

namespace sagara::render {

WakePart::WakePart(const PartContext& context, SeaPart& sea)
    : m_material(context.materials.make("wake", {Blending::Kind::Alpha, true, false})),
      m_object(context.scenes.createManualObject()) {
    sea.lift(m_material);
    m_object->setDynamic(true);
    m_object->setRenderQueueGroup(kFoamQueue);
    context.scenes.getRootSceneNode()->createChildSceneNode()->attachObject(m_object);
}

void WakePart::advance(const Frame& frame) {
    m_ribbons.clear();
    const auto add = [&](const ShipPose& pose, double length_m, double beam_m) {
        auto ribbons = foamOf(pose, length_m, beam_m);
        std::move(ribbons.begin(), ribbons.end(), std::back_inserter(m_ribbons));
    };
    for (std::size_t i = 0; i < std::min(frame.world.ships.size(), frame.moment.ships.size()); ++i) {
        const core::Hull& hull = frame.world.ships[i]->vessel.hull;
        add(frame.moment.ships[i], hull.lengthOverall_m, hull.beam_m);
    }
    for (const TargetPose& target : frame.moment.targets) {
        if (target.index >= frame.world.targets.size() + frame.moment.added.size()) continue;
        const core::TargetLayout& layout = core::targetLayout(frame.world, frame.moment.added, target.index);
        add(target, layout.length_m, layout.beam_m);
    }
}

void WakePart::look(const Frame&, const View& view) {
    m_object->setVisible(!m_ribbons.empty());
    if (m_ribbons.empty()) return;
    if (!std::exchange(m_begun, true))
        m_object->begin(m_material.ogre()->getName(), Ogre::RenderOperation::OT_TRIANGLE_LIST, kSceneGroup);
    else
        m_object->beginUpdate(0);
    std::uint32_t first = 0;
    for (const FoamRibbon& ribbon : m_ribbons) {
        for (const FoamPoint& p : ribbon) {
            m_object->position(relativeTo(view.camera, p.place, 0.0));
            m_object->textureCoord(static_cast<float>(p.across), static_cast<float>(p.along_m));
            m_object->textureCoord(static_cast<float>(p.strength), static_cast<float>(p.width_m));
        }
        for (std::uint32_t i = 0; i + 3 < ribbon.size(); i += 2)
            for (const std::uint32_t corner : {0u, 1u, 3u, 0u, 3u, 2u}) m_object->index(first + i + corner);
        first += static_cast<std::uint32_t>(ribbon.size());
    }
    m_object->end();
    m_object->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
}

}  // namespace sagara::render
