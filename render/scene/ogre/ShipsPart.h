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
    void join(const Fleet& fleet, std::size_t fromTarget) override;

private:
    /// Nodes of one ship's picture, in the order of ShipShape's members.
    struct Ship {
        Ogre::SceneNode* node = nullptr;
        Ogre::SceneNode* hull = nullptr;
        Ogre::SceneNode* upperworks = nullptr;
        Ogre::SceneNode* detail = nullptr;
        Ogre::SceneNode* lid = nullptr;
    };
    Ship build(const std::string& name, const ShipShape& shape);
    void place(const Ship& ship, const ShipPose& pose, const View& view, bool inside) const;

    Ogre::SceneManager& m_scenes;
    Materials& m_materials;
    ShaderMaterial m_solid;
    ShaderMaterial m_textured;
    ShaderMaterial m_lid;
    std::size_t m_joined = 0;  ///< for names that no mesh had before
    double m_detailWithin_m;
    std::vector<Ship> m_own;
    std::vector<Ship> m_targets;  ///< as World::targets
};

}  // namespace sagara::render
