#include "render/scene/ogre/SeaPart.h"

#include <OgreEntity.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/Angle.h"
#include "render/scene/ogre/Buffers.h"
#include "render/scene/sea/Foam.h"
#include "render/scene/sea/SeaGrid.h"

namespace sagara::render {
namespace {

/// Pictures up to this height take a net of two thirds: as fine on the screen as the other in a large one.
constexpr int kSmall_px = 480;
constexpr double kSector_rad = core::kTwoPi / kSeaSectors;

double fraction(double v) { return v - std::floor(v); }

/// Widest angle from the axis, seen from above, that a picture shows; pi when it shows the ground below.
double halfWidth_rad(const Camera& c) {
    const double tilt = std::abs(c.tilt_rad) + std::abs(c.pitch_rad) + std::abs(c.roll_rad);
    const double across = std::max(-c.lens.left, c.lens.right);
    const double upward = std::max(-c.lens.down, c.lens.up);
    const double ahead = std::cos(tilt) - upward * std::sin(tilt);
    return ahead < 0.15 ? core::kPi : std::atan2(across, ahead) + 0.5 * tilt;
}

}  // namespace

SeaPart::SeaPart(const PartContext& context)
    : m_tiles(context.world.waves),
      m_slopes(context.figures.mipmapsBetween ? Mipmaps::Between : Mipmaps::Nearest),
      m_material(context.materials.make("sea")),
      m_far("water-far", context.world.area, context.world.area.shelter.size()),
      m_near("water-near", context.world.area, 0),
      m_local(context.world.area, {}, 0.0) {
    for (std::size_t b = 0; b < 3; ++b) {
        const std::string number = std::to_string(b);
        m_heights[b] = floatTexture("height" + number, m_tiles.tiles()[b].height_m);
        m_surfaces[b] = byteTexture("surface" + number, m_tiles.tiles()[b].surface);
    }
    lift(m_material);
    m_material.set("u_deepWater", vector4(0.012, 0.062, 0.095, 0.0));
    m_material.set("u_shallowWater", vector4(0.035, 0.20, 0.20, 0.0));

    const int rings = context.figures.seaRings, columns = context.figures.seaColumnsPerSector;
    m_net = net(context, "sea", seaSector(rings, columns));
    m_smallNet = net(context, "sea-small", seaSector(2 * rings / 3, 2 * columns / 3));
}

SeaPart::Net SeaPart::net(const PartContext& context, const std::string& name, const SeaGrid& grid) {
    const Ogre::MeshPtr mesh =
        rawMesh(name, grid.vertices, 5, grid.indices, m_material.ogre(), Ogre::AxisAlignedBox::BOX_INFINITE);
    Net sectors;
    for (int i = 0; i < kSeaSectors; ++i) {
        auto* entity = context.scenes.createEntity(mesh);
        entity->setRenderQueueGroup(kSeaQueue);
        auto* node = context.scenes.getRootSceneNode()->createChildSceneNode();
        node->yaw(Ogre::Radian(static_cast<float>(-kSector_rad * i)));
        node->attachObject(entity);
        sectors.push_back(node);
    }
    return sectors;
}

void SeaPart::lift(ShaderMaterial& material) {
    for (std::size_t b = 0; b < 3; ++b) {
        material.addTexture("u_height" + std::to_string(b), m_heights[b], true, Mipmaps::Between);
        material.addTexture("u_surface" + std::to_string(b), m_surfaces[b], true, m_slopes);
    }
    material.addTexture("u_water", m_far.texture(), false, Mipmaps::None);
    material.addTexture("u_waterNear", m_near.texture(), false, Mipmaps::None);
    m_lifted.push_back(material);
}

void SeaPart::advance(const Frame& frame) {
    m_tiles.advance(frame.moment.sea, frame.moment.time);
    m_local = core::LocalWaves(frame.world.area, frame.moment.sea.systems, frame.moment.tide_m);
    m_far.follow(m_local, frame.moment.tide_m);
    m_near.follow(m_local, frame.moment.tide_m);
    const auto& t = m_tiles.tiles();
    for (std::size_t b = 0; b < 3; ++b) {
        upload(m_heights[b], t[b].height_m);
        upload(m_surfaces[b], t[b].surface);
    }
    m_material.setFragment("u_slopeScale", vector4(t[0].slopeScale, t[1].slopeScale, t[2].slopeScale, 0.0));
    m_material.setFragment(
        "u_accelerationScale",
        vector4(t[0].accelerationScale_mps2, t[1].accelerationScale_mps2, t[2].accelerationScale_mps2, 0.0));
    const SkyLight& light = frame.light;
    const double high = std::max(0.0, std::sin(light.sun.altitude_rad));
    double daylight = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        daylight += 0.33 * (light.skyColour[i] + 0.7 * high * light.sunColour[i]);
    m_material.setFragment("u_light",
                           vector4(1.0 - std::exp(-1500.0 * light.extinction_perM), daylight, 0.0, 0.0));
    const double rms = m_tiles.accelerationRms_mps2();
    const double crest = breakingAcceleration(frame.moment.weather.wind.speed_mps);
    m_material.setFragment("u_foam", vector4(rms * crest - 0.35 * rms, 0.9 * rms + 1e-3, 0.0, 0.0));
}

void SeaPart::look(const Frame&, const View& view) {
    const Camera& c = view.camera;
    const auto& tiles = m_tiles.tiles();
    for (std::size_t b = 0; b < 3; ++b) {
        const double tile = tiles[b].tile_m;
        const double east = c.position.east_m / tile, north = c.position.north_m / tile;
        const auto place = [&](int points) {  // a lattice point is the middle of its pixel
            const double half = 0.5 / points;
            return vector4(fraction(east + half), fraction(north + half), 1.0 / tile, points / tile);
        };
        const std::string name = "u_tile" + std::to_string(b);
        for (const ShaderMaterial& material : m_lifted) {
            material.setVertex(name, place(tiles[b].height_m.sizes[0]));
            material.setFragment(name, place(tiles[b].surface.sizes[0]));
        }
    }
    for (const ShaderMaterial& material : m_lifted) {
        material.setVertex("u_waterPlace", m_far.place(c.position));
        material.setVertex("u_waterNearPlace", m_near.place(c.position));
    }
    m_material.setVertex("u_grid", vector4(seaGridFactor(c.up_m), 0.0, 0.0, 0.0));

    const double axis = c.heading_rad + c.yaw_rad, half = halfWidth_rad(c) + 0.5 * kSector_rad + 0.02;
    const bool small = view.height <= kSmall_px;
    for (std::size_t i = 0; i < m_net.size(); ++i) {
        const double middle = kSector_rad * (static_cast<double>(i) + 0.5);
        const bool seen = std::abs(core::wrapPi(middle - axis)) < half;
        m_net[i]->setVisible(seen && !small);
        m_smallNet[i]->setVisible(seen && small);
    }
}

}  // namespace sagara::render
