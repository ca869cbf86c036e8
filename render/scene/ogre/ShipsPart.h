#pragma once

#include <string>

#include "render/scene/ogre/Part.h"

namespace sagara::render {

/// Hulls of own ships and targets.
class ShipsPart final : public Part {
public:
    ShipsPart(const PartContext& context, const ShaderMaterial& solid, const ShaderMaterial& textured);
    void advance(const Frame& frame) override;
    void look(const Frame& frame, const View& view) override;

private:
    /// Nodes of one ship's picture, in the order of ShipShape's members.
    struct Ship {
        Ogre::SceneNode* node = nullptr;
        Ogre::SceneNode* hull = nullptr;
        Ogre::SceneNode* upperworks = nullptr;
        Ogre::SceneNode* detail = nullptr;
        Ogre::SceneNode* lid = nullptr;
    };
    void place(const Ship& ship, const ShipPose& pose, const View& view, bool inside) const;

    double m_detailWithin_m;
    std::vector<Ship> m_own;
    std::vector<Ship> m_targets;  ///< as World::targets
};

}  // namespace sagara::render
