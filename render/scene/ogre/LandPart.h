#pragma once

#include "render/scene/ogre/Part.h"

namespace sagara::render {

/// Land with its harbour works and buildings. It falls and rises with the tide, since still water is the zero
/// of all heights.
class LandPart final : public Part {
public:
    LandPart(const PartContext& context, const ShaderMaterial& solid);
    void advance(const Frame& frame) override;
    void look(const Frame& frame, const View& view) override;

private:
    Ogre::SceneNode* m_node;
    double m_waterAboveMean_m = 0.0;
};

}  // namespace sagara::render
