#include "render/scene/ogre/LinesPart.h"

#include <algorithm>
#include <utility>

#include "render/scene/ogre/Axes.h"

namespace sagara::render {
namespace {

/// How much of its colour a rope of so many pixels shows: more than it covers, for the eye follows a line
/// that is thinner than what else it can see, and nothing in the end.
float strengthOf(float breadth_px) {
    const float near = std::clamp((breadth_px - 0.04f) / 0.2f, 0.0f, 1.0f);
    return std::min(1.0f, std::max(breadth_px, 0.6f * near));
}

}  // namespace

LinesPart::LinesPart(const PartContext& context)
    : m_material(context.materials.make("line", {Blending::Kind::Alpha, true, false})),
      m_object(context.scenes.createManualObject()) {
    m_object->setDynamic(true);
    m_object->setRenderQueueGroup(kLineQueue);
    context.scenes.getRootSceneNode()->createChildSceneNode()->attachObject(m_object);
}

void LinesPart::advance(const Frame& frame) { m_ropes = ropesOf(frame.world, frame.moment); }

std::uint32_t LinesPart::add(const Rope& rope, const View& view, std::uint32_t first) {
    std::vector<Ogre::Vector3> points;
    for (const PlaceUp& p : rope.points) points.push_back(relativeTo(view.camera, p.position, p.up_m));
    const auto pixel = static_cast<float>((view.camera.lens.right - view.camera.lens.left) / view.width);
    const float half_m = 0.5f * static_cast<float>(rope.diameter_m);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Ogre::Vector3 along = points[std::min(i + 1, points.size() - 1)] - points[i > 0 ? i - 1 : 0];
        const float pixel_m = pixel * std::max(0.1f, points[i].length());
        const float half_px = half_m / pixel_m;
        // Half a pixel more on either side, over which it fades.
        const float drawn_px = std::max(0.5f, half_px) + 0.5f;
        const float strength = strengthOf(2.0f * half_px);
        const Ogre::Vector3 aside = along.crossProduct(points[i]).normalisedCopy();  // zero when end on
        for (const float side : {-1.0f, 1.0f}) {
            m_object->position(points[i] + side * drawn_px * pixel_m * aside);
            m_object->colour(static_cast<float>(rope.paint.red), static_cast<float>(rope.paint.green),
                             static_cast<float>(rope.paint.blue), strength);
            m_object->textureCoord(side, drawn_px);
        }
    }
    const auto count = static_cast<std::uint32_t>(2 * points.size());
    for (std::uint32_t i = 0; i + 3 < count; i += 2)
        for (const std::uint32_t corner : {0u, 1u, 3u, 0u, 3u, 2u}) m_object->index(first + i + corner);
    return count;
}

void LinesPart::look(const Frame&, const View& view) {
    m_object->setVisible(!m_ropes.empty());
    if (m_ropes.empty()) return;
    if (!std::exchange(m_begun, true))
        m_object->begin(m_material.ogre()->getName(), Ogre::RenderOperation::OT_TRIANGLE_LIST, kSceneGroup);
    else
        m_object->beginUpdate(0);
    std::uint32_t first = 0;
    for (const Rope& rope : m_ropes) first += add(rope, view, first);
    m_object->end();
    m_object->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
}

}  // namespace sagara::render
