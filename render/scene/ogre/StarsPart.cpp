#include "render/scene/ogre/StarsPart.h"

#include <cmath>

#include "render/scene/ogre/Axes.h"
#include "render/scene/sky/Stars.h"

namespace sagara::render {
namespace {

/// Of a point of the sphere: x to right ascension 0, y to the north pole, z completing a right-handed frame.
Ogre::Vector3 onSphere(Equatorial e) {
    const double level = std::cos(e.declination_rad);
    return {static_cast<float>(level * std::cos(e.rightAscension_rad)),
            static_cast<float>(std::sin(e.declination_rad)),
            static_cast<float>(-level * std::sin(e.rightAscension_rad))};
}

Ogre::Vector3 inSky(const Horizontal& h) {
    const double level = std::cos(h.altitude_rad);
    return ogreFromNed(level * std::cos(h.bearing_rad), level * std::sin(h.bearing_rad),
                       -std::sin(h.altitude_rad));
}

}  // namespace

StarsPart::StarsPart(const PartContext& context)
    : m_material(context.materials.make("star", {Blending::Kind::Add, true, false})),
      m_sprites(context.scenes, m_material) {
    std::vector<Sprite> sprites;
    for (const Star& star : starsOfTheSky()) {
        const double bright = std::clamp(1.05 - 0.19 * star.magnitude, 0.12, 1.0);
        const double size = std::clamp(2.6 - 0.3 * star.magnitude, 1.2, 3.0);
        sprites.push_back({1000.0f * onSphere(star.position), {bright, bright, 0.97 * bright}, size, size});
    }
    m_sprites.fill(sprites);
}

void StarsPart::advance(const Frame& frame) {
    const double seen = frame.light.night * std::exp(-3000.0 * frame.light.extinction_perM) *
                        std::clamp(1.3 - 1.3 * frame.light.cloudCover, 0.0, 1.0);
    m_sprites.node().setVisible(seen > 0.03);
    m_material.setFragment("u_brightness", vector4(1.8 * seen, 0.0, 0.0, 0.0));
    // The turn of the sphere, from where its axes are seen.
    const core::GeoPoint place = frame.world.area.frame.datum();
    const SkyTime time = SkyTime::of(frame.world.start, frame.moment.time.seconds());
    const Ogre::Vector3 x = inSky(seenFrom(place, time, {0.0, 0.0})),
                        y = inSky(seenFrom(place, time, {0.0, 1.5707963267948966}));
    Ogre::Matrix3 axes;
    axes.FromAxes(x, y, x.crossProduct(y));
    m_sprites.node().setOrientation(Ogre::Quaternion(axes));
}

void StarsPart::look(const Frame&, const View& view) {
    m_material.setVertex("u_screen", vector4(2.0 / view.width, 2.0 / view.height, 1.0, 0.0));
}

}  // namespace sagara::render
