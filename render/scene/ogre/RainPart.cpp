#include "render/scene/ogre/RainPart.h"

#include <OgreEntity.h>

#include <cmath>

#include "core/base/Random.h"
#include "render/scene/ogre/Buffers.h"

namespace sagara::render {
namespace {

constexpr int kStreaks = 1200;
constexpr double kBox_m = 24.0;  // as in rain.vert
constexpr double kFall_mps = 8.0;

double share(double metres) { return std::fmod(metres / kBox_m, 1.0); }

}  // namespace

RainPart::RainPart(const PartContext& context)
    : m_material(context.materials.make("rain", {Blending::Kind::Alpha, true, false})),
      m_node(context.scenes.getRootSceneNode()->createChildSceneNode()) {
    core::Random random(7);
    std::vector<float> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < kStreaks; ++i) {
        const double place[] = {random.uniform(), random.uniform(), random.uniform()};
        for (const auto& [side, end] : {std::pair{-1.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
            for (const double v : place) vertices.push_back(static_cast<float>(v));
            vertices.push_back(side);
            vertices.push_back(end);
        }
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(4 * i + corner);
    }
    auto* entity = context.scenes.createEntity(
        rawMesh("rain", vertices, 5, indices, m_material.ogre(), Ogre::AxisAlignedBox::BOX_INFINITE));
    entity->setRenderQueueGroup(kSpriteQueue + 1);
    m_node->attachObject(entity);
}

void RainPart::advance(const Frame& frame) { m_node->setVisible(frame.light.rain > 0.0); }

void RainPart::look(const Frame& frame, const View& view) {
    const Camera& c = view.camera;
    const double fallen_m = kFall_mps * frame.moment.time.seconds();
    m_material.setVertex("u_place", vector4(share(c.position.east_m), share(c.up_m + fallen_m),
                                            share(-c.position.north_m), 0.0));
    m_material.setVertex("u_screen", vector4(2.0 / view.width, 2.0 / view.height, 0.0, 0.0));
}

}  // namespace sagara::render
