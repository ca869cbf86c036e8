#include "render/scene/ogre/Sprites.h"

#include <array>
#include <utility>

namespace sagara::render {

Sprites::Sprites(Ogre::SceneManager& scenes, const ShaderMaterial& material)
    : m_object(scenes.createManualObject()),
      m_node(scenes.getRootSceneNode()->createChildSceneNode()),
      m_material(material.ogre()->getName()) {
    m_object->setDynamic(true);
    m_object->setRenderQueueGroup(kSpriteQueue);
    m_node->attachObject(m_object);
}

void Sprites::fill(const std::vector<Sprite>& sprites) {
    m_object->setVisible(!sprites.empty());
    if (sprites.empty()) return;
    if (!std::exchange(m_begun, true))
        m_object->begin(m_material, Ogre::RenderOperation::OT_TRIANGLE_LIST, kSceneGroup);
    else
        m_object->beginUpdate(0);
    constexpr std::array<std::array<float, 2>, 4> kCorners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    std::uint32_t first = 0;
    for (const Sprite& s : sprites) {
        for (const auto& corner : kCorners) {
            m_object->position(s.place);
            m_object->colour(static_cast<float>(s.colour[0]), static_cast<float>(s.colour[1]),
                             static_cast<float>(s.colour[2]), 1.0f);
            m_object->textureCoord(corner[0], corner[1]);
            m_object->textureCoord(static_cast<float>(s.width_px), static_cast<float>(s.height_px));
        }
        for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) m_object->index(first + i);
        first += 4;
    }
    m_object->end();
    m_object->setBoundingBox(Ogre::AxisAlignedBox::BOX_INFINITE);
}

}  // namespace sagara::render
