#pragma once

#include <OgreManualObject.h>

#include "render/scene/ogre/Part.h"
#include "render/scene/rope/Ropes.h"

namespace sagara::render {

/// Mooring lines and anchor cables: ribbons turned to the eye, never thinner than a pixel, for a thin bar
/// would come and go as ships move. All in one draw call.
class LinesPart final : public Part {
public:
    explicit LinesPart(const PartContext& context);
    void advance(const Frame& frame) override;
    void look(const Frame& frame, const View& view) override;

private:
    /// Returns how many points it has put in.
    std::uint32_t add(const Rope& rope, const View& view, std::uint32_t first);

    ShaderMaterial m_material;
    Ogre::ManualObject* m_object;
    bool m_begun = false;
    std::vector<Rope> m_ropes;
};

}  // namespace sagara::render
