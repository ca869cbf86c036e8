#include "render/scene/ogre/Materials.h"

#include <OgreException.h>
#include <OgreHighLevelGpuProgram.h>
#include <OgreHighLevelGpuProgramManager.h>
#include <OgreMaterialManager.h>
#include <OgreResourceGroupManager.h>
#include <OgreTechnique.h>

#include <fstream>
#include <string_view>

#include "render/scene/ogre/Part.h"

namespace sagara::render {
namespace {

const std::string& kGroup = kSceneGroup;

Ogre::Pass& passOf(const Ogre::MaterialPtr& material) { return *material->getTechnique(0)->getPass(0); }

void set(const Ogre::GpuProgramParametersSharedPtr& parameters, const std::string& uniform,
         const Ogre::Vector4& value) {
    if (parameters->_findNamedConstantDefinition(uniform) != nullptr)
        parameters->setNamedConstant(uniform, value);
}

void apply(Ogre::Pass& pass, Blending blending) {
    pass.setLightingEnabled(false);
    pass.setCullingMode(Ogre::CULL_NONE);  // shaders turn normals towards the eye
    pass.setDepthCheckEnabled(blending.depthTest);
    pass.setDepthWriteEnabled(blending.depthWrite);
    pass.setColourWriteEnabled(blending.colourWrite);
    if (blending.kind == Blending::Kind::Alpha) pass.setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
    if (blending.kind == Blending::Kind::Add) pass.setSceneBlending(Ogre::SBT_ADD);
}

void addProgram(Ogre::Pass& pass, const std::string& name, Ogre::GpuProgramType type,
                const std::string& source) {
    auto program = Ogre::HighLevelGpuProgramManager::getSingleton().createProgram(name, kGroup, "glsl", type);
    program->setSource(source);
    program->load();
    if (program->hasCompileError())
        OGRE_EXCEPT(Ogre::Exception::ERR_RENDERINGAPI_ERROR, "shader " + name + " does not compile");
    if (type == Ogre::GPT_VERTEX_PROGRAM)
        pass.setVertexProgram(name);
    else
        pass.setFragmentProgram(name);
}

}  // namespace

void ShaderMaterial::setVertex(const std::string& uniform, const Ogre::Vector4& value) const {
    render::set(passOf(m_material).getVertexProgramParameters(), uniform, value);
}
void ShaderMaterial::setFragment(const std::string& uniform, const Ogre::Vector4& value) const {
    render::set(passOf(m_material).getFragmentProgramParameters(), uniform, value);
}
void ShaderMaterial::set(const std::string& uniform, const Ogre::Vector4& value) const {
    setVertex(uniform, value);
    setFragment(uniform, value);
}

void ShaderMaterial::addTexture(const std::string& uniform, const Ogre::TexturePtr& texture, bool wrap,
                                Mipmaps mipmaps) {
    Ogre::Pass& pass = passOf(m_material);
    const int unit = pass.getNumTextureUnitStates();
    Ogre::TextureUnitState* state = pass.createTextureUnitState();
    state->setTexture(texture);
    state->setTextureAddressingMode(wrap ? Ogre::TextureUnitState::TAM_WRAP
                                         : Ogre::TextureUnitState::TAM_CLAMP);
    state->setTextureFiltering(Ogre::FO_LINEAR, Ogre::FO_LINEAR,
                               mipmaps == Mipmaps::None      ? Ogre::FO_NONE
                               : mipmaps == Mipmaps::Nearest ? Ogre::FO_POINT
                                                             : Ogre::FO_LINEAR);
    for (const auto& parameters : {pass.getVertexProgramParameters(), pass.getFragmentProgramParameters()}) {
        if (parameters->_findNamedConstantDefinition(uniform) != nullptr)
            parameters->setNamedConstant(uniform, unit);
    }
}

Materials::Materials(std::filesystem::path shaders, const PresetFigures& figures)
    : m_shaders(std::move(shaders)) {
    m_head = "#version 330 core\n";
    if (figures.clouds) m_head += "#define CLOUDS\n";
    if (figures.foam) m_head += "#define FOAM\n";
    if (figures.shortWaves) m_head += "#define SHORT_WAVES\n";
    m_head += source("common.glsl");
}

std::string Materials::source(const std::string& file) const {
    constexpr std::string_view kInclude = "#include \"";
    std::ifstream in(m_shaders / file);
    if (!in)
        OGRE_EXCEPT(Ogre::Exception::ERR_FILE_NOT_FOUND, (m_shaders / file).string() + " cannot be read");
    std::string text, line;
    while (std::getline(in, line)) {
        if (line.starts_with(kInclude))
            text += source(line.substr(kInclude.size(), line.rfind('"') - kInclude.size()));
        else
            text += line + "\n";
    }
    return text;
}

ShaderMaterial Materials::make(const std::string& name, Blending blending) {
    auto material = Ogre::MaterialManager::getSingleton().create(name, kGroup);
    Ogre::Pass& pass = passOf(material);
    apply(pass, blending);
    addProgram(pass, name + ".vert", Ogre::GPT_VERTEX_PROGRAM, m_head + source(name + ".vert"));
    addProgram(pass, name + ".frag", Ogre::GPT_FRAGMENT_PROGRAM, m_head + source(name + ".frag"));
    const auto vertex = pass.getVertexProgramParameters();
    vertex->setIgnoreMissingParams(true);  // the compiler drops what is not used
    vertex->setNamedAutoConstant("u_world", Ogre::GpuProgramParameters::ACT_WORLD_MATRIX);
    vertex->setNamedAutoConstant("u_viewProjection", Ogre::GpuProgramParameters::ACT_VIEWPROJ_MATRIX);
    pass.getFragmentProgramParameters()->setIgnoreMissingParams(true);
    m_all.emplace_back(material);
    return m_all.back();
}

ShaderMaterial Materials::withTexture(const ShaderMaterial& material, const std::string& name,
                                      const std::string& uniform, const Ogre::TexturePtr& texture) {
    ShaderMaterial copy(material.ogre()->clone(name, true, kGroup));
    copy.addTexture(uniform, texture, true, Mipmaps::Between);
    m_all.push_back(copy);
    return copy;
}

void Materials::setForAll(const std::string& uniform, const Ogre::Vector4& value) const {
    for (const ShaderMaterial& material : m_all) material.set(uniform, value);
}

}  // namespace sagara::render
