#include "render/scene/ogre/SkyPart.h"

#include <OgreEntity.h>

#include <cmath>

#include "core/base/Units.h"
#include "render/scene/ogre/Axes.h"
#include "render/scene/ogre/Buffers.h"
#include "render/scene/sky/Noise.h"

namespace sagara::render {
namespace {

constexpr int kCloudSize = 512;
/// Half of 1 / radius, with the radius a sixth greater for the bending of light near the horizon.
constexpr double kCurvature_perM = 0.5 / (6'371'000.0 * 7.0 / 6.0);

Ogre::Vector4 towards(Horizontal h, double w = 0.0) {
    const double level = std::cos(h.altitude_rad);
    const Ogre::Vector3 v = ogreFromNed(level * std::cos(h.bearing_rad), level * std::sin(h.bearing_rad),
                                        -std::sin(h.altitude_rad));
    return {v.x, v.y, v.z, static_cast<float>(w)};
}

/// A dome about the eye, from a little below the horizon. Colours of the clear sky are worked out at its
/// points, so these stand closer where they change fast.
Ogre::MeshPtr dome(const Ogre::MaterialPtr& material) {
    constexpr int kRows = 20, kColumns = 48;
    constexpr double kLowest_rad = -0.1;
    std::vector<float> vertices;
    std::vector<std::uint32_t> indices;
    for (int row = 0; row <= kRows; ++row) {
        for (int column = 0; column <= kColumns; ++column) {
            const double up = static_cast<double>(row - 1) / (kRows - 1);
            const double a = row == 0 ? kLowest_rad : 0.5 * core::kPi * up * up;
            const double b = core::kTwoPi * column / kColumns;
            for (const double v : {std::cos(a) * std::sin(b), std::sin(a), std::cos(a) * std::cos(b)})
                vertices.push_back(static_cast<float>(100.0 * v));
        }
    }
    for (std::uint32_t row = 0; row < kRows; ++row) {
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const std::uint32_t i = row * (kColumns + 1) + column, j = i + kColumns + 1;
            indices.insert(indices.end(), {i, i + 1, j + 1, i, j + 1, j});
        }
    }
    return rawMesh("sky", vertices, 3, indices, material, Ogre::AxisAlignedBox::BOX_INFINITE);
}

}  // namespace

SkyPart::SkyPart(const PartContext& context)
    : m_materials(context.materials),
      m_sky(context.materials.make("sky", {Blending::Kind::Opaque, true, false})),
      m_moon(context.scenes.getRootSceneNode()->createChildSceneNode()) {
    if (context.figures.clouds)
        m_sky.addTexture("u_clouds", byteTexture("clouds", kCloudSize, kCloudSize, cloudNoise(kCloudSize)),
                         true, Mipmaps::None);
    auto* entity = context.scenes.createEntity(dome(m_sky.ogre()));
    entity->setRenderQueueGroup(kSkyQueue);
    context.scenes.getRootSceneNode()->createChildSceneNode()->attachObject(entity);
    const ShaderMaterial moon = context.materials.make("moon", {Blending::Kind::Add, true, false});
    constexpr float kSquare[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    constexpr std::uint32_t kHalves[] = {0, 1, 2, 0, 2, 3};
    auto* disc = context.scenes.createEntity(
        rawMesh("moon", kSquare, 3, kHalves, moon.ogre(), Ogre::AxisAlignedBox::BOX_INFINITE));
    disc->setRenderQueueGroup(kSkyQueue + 1);
    m_moon->attachObject(disc);
}

void SkyPart::advance(const Frame& frame) {
    const SkyLight& l = frame.light;
    m_moon->setVisible(l.moon.seen.altitude_rad > -0.01);
    m_materials.setForAll("u_sun", towards(l.sun));
    m_materials.setForAll("u_sunColour", vector4(l.sunColour));
    m_materials.setForAll("u_sky", vector4(l.skyColour));
    m_materials.setForAll("u_zenith", vector4(l.zenith));
    m_materials.setForAll("u_horizon", vector4(l.horizon, l.extinction_perM));
    m_materials.setForAll("u_glow", vector4(l.glow));
    m_materials.setForAll("u_moon", towards(l.moon.seen, l.moon.litShare));
    m_materials.setForAll("u_moonColour", vector4(l.lowLight));
    const bool day = l.sun.altitude_rad > -0.01;
    const auto glitter = [&](std::size_t i) {
        return day ? l.sunColour[i] + 0.3 * l.glow[i] : 3.0 * l.lowLight[i];
    };
    m_materials.setForAll("u_lamp", towards(day ? l.sun : l.moon.seen));
    m_materials.setForAll("u_lampColour", vector4(glitter(0), glitter(1), glitter(2), 0.0));
    const double drift = 0.0003 * frame.moment.time.seconds();
    m_materials.setForAll("u_cloud",
                          vector4(l.cloudCover, std::fmod(0.7 * drift, 1.0), std::fmod(drift, 1.0), l.rain));
}

void SkyPart::look(const Frame& frame, const View& view) {
    m_materials.setForAll("u_eye", vector4(view.camera.up_m, std::fmod(frame.moment.time.seconds(), 600.0),
                                           kCurvature_perM, frame.light.night));
}

}  // namespace sagara::render
