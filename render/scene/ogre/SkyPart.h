#pragma once

#include "render/scene/ogre/Part.h"

namespace sagara::render {

/// Sky with sun, moon and clouds; and the light and air every material shares.
class SkyPart final : public Part {
public:
    explicit SkyPart(const PartContext& context);
    void advance(const Frame& frame) override;
    void look(const Frame& frame, const View& view) override;

private:
    Materials& m_materials;
    ShaderMaterial m_sky;
    Ogre::SceneNode* m_moon;
};

}  // namespace sagara::render
