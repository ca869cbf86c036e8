#pragma once

#include <OgreMesh.h>
#include <OgreTexture.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "render/scene/sea/SeaTiles.h"
#include "render/scene/shape/TexturedSolid.h"

/// From plain values to what OGRE draws.
namespace sagara::render {

Ogre::MeshPtr meshOf(const std::string& name, const Solid& solid, const Ogre::MaterialPtr& material);
Ogre::MeshPtr meshOf(const std::string& name, const TexturedSolid& textured,
                     const Ogre::MaterialPtr& material);

/// A mesh of vertices that hold `floats` floats each, laid out as three of position and then texture
/// coordinates in pairs.
Ogre::MeshPtr rawMesh(const std::string& name, std::span<const float> vertices, std::size_t floatsEach,
                      std::span<const std::uint32_t> indices, const Ogre::MaterialPtr& material,
                      const Ogre::AxisAlignedBox& bounds);

Ogre::TexturePtr floatTexture(const std::string& name, const MipChain<float>& chain);
Ogre::TexturePtr byteTexture(const std::string& name, const MipChain<std::uint32_t>& chain);
/// Red in the lowest byte.
Ogre::TexturePtr byteTexture(const std::string& name, int width, int height,
                             const std::vector<std::uint32_t>& pixels);
/// With mipmaps.
Ogre::TexturePtr texture(const std::string& name, const TextureImage& image);
void upload(const Ogre::TexturePtr& texture, const std::vector<std::uint32_t>& pixels);
void upload(const Ogre::TexturePtr& texture, const MipChain<float>& chain);
void upload(const Ogre::TexturePtr& texture, const MipChain<std::uint32_t>& chain);

}  // namespace sagara::render
