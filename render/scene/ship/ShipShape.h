#pragma once

#include "render/scene/shape/Solid.h"
#include "render/scene/shape/TexturedSolid.h"
#include "render/scene/ship/ShipForm.h"

namespace sagara::render {

/// A ship's picture in three parts, in her own frame. Worked out from her form, or from a model
/// (ModelFile.h).
struct ShipShape {
    Solid hull;        ///< shell, deck and what stands on the deck ahead: in view from her own bridge
    Solid upperworks;  ///< around the eye on her bridge, so left out there
    Solid detail;      ///< thin things that far ships need not show
    Solid lid;         ///< of a low hull, unseen: keeps the picture of the sea out of it
    /// The same of models that have textures, one for each texture.
    struct Textured {
        std::vector<TexturedSolid> hull;
        std::vector<TexturedSolid> upperworks;
        std::vector<TexturedSolid> detail;
    } textured;
};
/// `variant` chooses among colours usual for the type.
ShipShape shapeOf(const ShipForm& form, unsigned variant);

}  // namespace sagara::render
