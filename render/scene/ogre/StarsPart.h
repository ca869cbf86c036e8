#pragma once

#include "render/scene/ogre/Sprites.h"

namespace sagara::render {

/// Stars, turned with the hour; seen through what cloud and air leave.
class StarsPart final : public Part {
public:
    explicit StarsPart(const PartContext& context);
    void advance(const Frame& frame) override;
    void look(const Frame& frame, const View& view) override;

private:
    ShaderMaterial m_material;
    Sprites m_sprites;
};

}  // namespace sagara::render
