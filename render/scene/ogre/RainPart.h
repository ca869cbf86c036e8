#pragma once

#include "render/scene/ogre/Part.h"

namespace sagara::render {

/// Streaks of rain near the eye. What rain does to light and visibility is SkyLight's.
class RainPart final : public Part {
public:
    explicit RainPart(const PartContext& context);
    void advance(const Frame& frame) override;
    void look(const Frame& frame, const View& view) override;

private:
    ShaderMaterial m_material;
    Ogre::SceneNode* m_node;
};

}  // namespace sagara::render
