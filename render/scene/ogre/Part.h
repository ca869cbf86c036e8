#pragma once

#include <OgreSceneManager.h>

#include "render/scene/Camera.h"
#include "render/scene/Moment.h"
#include "render/scene/Preset.h"
#include "render/scene/ogre/Materials.h"
#include "render/scene/ship/Fleet.h"
#include "render/scene/sky/SkyLight.h"

namespace sagara::render {

/// Resources of the running exercise; the group goes with it.
inline const std::string kSceneGroup = "exercise";

/// What parts are made from.
struct PartContext {
    const core::World& world;
    Ogre::SceneManager& scenes;
    Materials& materials;
    const PresetFigures& figures;
    const Fleet& fleet;
};

/// One instant, the same for all views.
struct Frame {
    const core::World& world;
    const Moment& moment;
    const SkyLight& light;
};

/// One picture of it.
struct View {
    const Camera& camera;
    int width;
    int height;
};

/// A part of the picture: what moves with time in `advance`, what depends on the eye in `look`. Places are
/// relative to the eye, so everything is placed anew for each view.
class Part {
public:
    virtual ~Part() = default;
    virtual void advance(const Frame& frame) = 0;
    virtual void look(const Frame& frame, const View& view) = 0;
    /// The targets from the one of that index on look as the fleet says now: some have been added.
    virtual void join(const Fleet& fleet, std::size_t fromTarget) {
        (void)fleet;
        (void)fromTarget;
    }
};

/// What is drawn first: the sky last of the solid things, where nothing else is; then what lets light
/// through.
enum Queue : std::uint8_t {
    kSolidQueue = 50,
    kLidQueue = 55,
    kSeaQueue = 60,
    kSkyQueue = 70,
    kFoamQueue = 75,
    kLineQueue = 77,
    kSpriteQueue = 80
};

inline Ogre::Vector4 vector4(const Colour& c, double w = 0.0) {
    return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]),
            static_cast<float>(w)};
}
inline Ogre::Vector4 vector4(double x, double y, double z, double w) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), static_cast<float>(w)};
}

}  // namespace sagara::render
