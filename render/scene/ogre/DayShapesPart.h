#pragma once

#include <OgreManualObject.h>

#include "render/scene/ogre/Part.h"
#include "render/scene/shape/Solid.h"
#include "render/scene/ship/ShipForm.h"

namespace sagara::render {

/// Balls, cones and diamonds that ships hoist, all in one draw call.
class DayShapesPart final : public Part {
public:
    DayShapesPart(const PartContext& context, const ShaderMaterial& solid);
    void advance(const Frame& frame) override;
    void look(const Frame& frame, const View& view) override;
    void join(const Fleet& fleet, std::size_t fromTarget) override;

private:
    struct Hoist {
        PlaceUp place;
        Solid shape;
        double size_m;
        std::optional<std::size_t> abaftBridgeOf;  ///< own ship; not seen from inside her
    };
    void add(const ShipForm& form, const ShipPose& pose, std::optional<std::size_t> own);
    bool isSeen(const Hoist& hoist, const View& view) const;

    std::string m_material;
    Ogre::ManualObject* m_object;
    bool m_begun = false;
    std::vector<ShipForm> m_own;
    std::vector<ShipForm> m_targets;
    std::vector<Hoist> m_hoists;
};

}  // namespace sagara::render
