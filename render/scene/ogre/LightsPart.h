#pragma once

#include "core/world/LightCharacter.h"
#include "render/scene/light/ShipLights.h"
#include "render/scene/ogre/SeaPart.h"
#include "render/scene/ogre/Sprites.h"

namespace sagara::render {

/// Marks with their lights, and the lights of ships.
class LightsPart final : public Part {
public:
    LightsPart(const PartContext& context, const ShaderMaterial& solid, const SeaPart& sea);
    void advance(const Frame& frame) override;
    void look(const Frame& frame, const View& view) override;
    void join(const Fleet& fleet, std::size_t fromTarget) override;

private:
    struct MarkInSea {
        const core::Mark* mark;
        Ogre::SceneNode* node;
        std::optional<core::LightCharacter> character;
        double up_m = 0.0;  ///< of its waterline now
    };
    void shine(const Frame& frame, const View& view, core::NorthEast p, double up_m, const Colour& colour,
               double strength_cd);
    void shipLights(const Frame& frame, const View& view, const ShipForm& form, const ShipPose& pose);

    const SeaPart& m_sea;
    ShaderMaterial m_material;
    Sprites m_sprites;
    std::vector<MarkInSea> m_marks;
    std::vector<ShipForm> m_own;
    std::vector<ShipForm> m_targets;
    std::vector<Sprite> m_list;
};

}  // namespace sagara::render
