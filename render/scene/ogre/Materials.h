#pragma once

#include <OgreGpuProgramParams.h>
#include <OgreMaterial.h>
#include <OgreVector.h>

#include <filesystem>
#include <string>
#include <vector>

#include "render/scene/Preset.h"

namespace sagara::render {

/// How a material meets what is already in the picture.
struct Blending {
    enum class Kind { Opaque, Alpha, Add } kind = Kind::Opaque;
    bool depthTest = true;
    bool depthWrite = true;
    bool colourWrite = true;
};

/// Which mipmaps a look at a texture takes: none, the nearest, or the two nearest with what lies between.
/// Without a graphics card the second costs half of what the third does.
enum class Mipmaps { None, Nearest, Between };

/// A material of ours: one pass with two programs from assets/shaders.
class ShaderMaterial {
public:
    explicit ShaderMaterial(Ogre::MaterialPtr material) : m_material(std::move(material)) {}
    const Ogre::MaterialPtr& ogre() const { return m_material; }
    void set(const std::string& uniform, const Ogre::Vector4& value) const;
    void setVertex(const std::string& uniform, const Ogre::Vector4& value) const;
    void setFragment(const std::string& uniform, const Ogre::Vector4& value) const;
    /// Bilinear in each.
    void addTexture(const std::string& uniform, const Ogre::TexturePtr& texture, bool wrap, Mipmaps mipmaps);

private:
    Ogre::MaterialPtr m_material;
};

/// Makes materials, and sets what they all share.
class Materials {
public:
    Materials(std::filesystem::path shaders, const PresetFigures& figures);
    /// Programs `name`.vert and `name`.frag. Throws Ogre::Exception with the compiler's words.
    ShaderMaterial make(const std::string& name, Blending blending = {});
    /// The same programs with a texture: its mipmaps are used, it goes on beyond its edges.
    ShaderMaterial withTexture(const ShaderMaterial& material, const std::string& name,
                               const std::string& uniform, const Ogre::TexturePtr& texture);
    void setForAll(const std::string& uniform, const Ogre::Vector4& value) const;

private:
    std::string source(const std::string& file) const;

    std::filesystem::path m_shaders;
    std::string m_head;  ///< version, defines, common.glsl
    std::vector<ShaderMaterial> m_all;
};

}  // namespace sagara::render
