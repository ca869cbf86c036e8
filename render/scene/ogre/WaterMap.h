#pragma once

#include <OgreTexture.h>
#include <OgreVector.h>

#include <optional>
#include <string>
#include <vector>

#include "core/world/LocalWaves.h"

namespace sagara::render {

/// What of the water changes from place to place, as a texture over one of the area's grids for lift.glsl:
/// red is the factor on the waves' heights over LocalWaves::kMostFactor, green the charted depth.
class WaterMap {
public:
    /// `index`: of the grids of shelter, or where there are none of depth; the last where there are fewer.
    WaterMap(const std::string& name, const core::Area& area, std::size_t index);
    /// Draws it again when the waves are others than those it shows.
    void follow(const core::LocalWaves& waves, double tide_m);
    /// xy: a place in the texture, zw: 1 / size.
    Ogre::Vector4 place(core::NorthEast p) const;
    const Ogre::TexturePtr& texture() const { return m_texture; }

private:
    struct Shown {
        double height_m, period_s, tide_m;
    };
    std::vector<std::uint32_t> pixels(const core::LocalWaves& waves) const;

    core::NorthEast m_southWest{0.0, 0.0};
    double m_east_m = 1e9, m_north_m = 1e9;
    std::size_t m_rows = 2, m_columns = 2;
    bool m_shoaling;
    std::vector<float> m_shelter, m_depth_m;  ///< of every pixel
    std::optional<Shown> m_shown;
    Ogre::TexturePtr m_texture;
};

}  // namespace sagara::render
