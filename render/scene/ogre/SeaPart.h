#pragma once

#include <array>

#include "render/scene/ogre/Part.h"
#include "render/scene/ogre/WaterMap.h"
#include "render/scene/sea/SeaGrid.h"
#include "render/scene/sea/SeaTiles.h"

namespace sagara::render {

/// The sea: core's waves on a polar grid about the eye.
class SeaPart final : public Part {
public:
    explicit SeaPart(const PartContext& context);
    void advance(const Frame& frame) override;
    void look(const Frame& frame, const View& view) override;
    /// Gives a material what lift.glsl needs, and the slope maps, and keeps them up to date.
    void lift(ShaderMaterial& material);
    /// Of the surface, above still water.
    double height_m(core::NorthEast p) const { return m_local.factorAt(p) * m_tiles.elevation_m(p); }

private:
    using Net = std::vector<Ogre::SceneNode*>;  ///< a node a sector
    Net net(const PartContext& context, const std::string& name, const SeaGrid& grid);

    SeaTiles m_tiles;
    Mipmaps m_slopes;
    ShaderMaterial m_material;
    std::array<Ogre::TexturePtr, 3> m_heights;
    std::array<Ogre::TexturePtr, 3> m_surfaces;
    WaterMap m_far;
    WaterMap m_near;
    core::LocalWaves m_local;
    Net m_net;
    Net m_smallNet;
    std::vector<ShaderMaterial> m_lifted;
};

}  // namespace sagara::render
