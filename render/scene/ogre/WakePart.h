#pragma once

#include <OgreManualObject.h>

#include "render/scene/ogre/SeaPart.h"
#include "render/scene/sea/Wake.h"

namespace sagara::render {

/// Wakes and bow waves of all ships.
class WakePart final : public Part {
public:
    WakePart(const PartContext& context, SeaPart& sea);
    void advance(const Frame& frame) override;
    void look(const Frame& frame, const View& view) override;

private:
    ShaderMaterial m_material;
    Ogre::ManualObject* m_object;
    bool m_begun = false;
    std::vector<FoamRibbon> m_ribbons;
};

}  // namespace sagara::render
