#include "render/scene/ogre/Buffers.h"

#include <OgreHardwareBufferManager.h>
#include <OgreHardwarePixelBuffer.h>
#include <OgreMeshManager.h>
#include <OgreResourceGroupManager.h>
#include <OgreSubMesh.h>
#include <OgreTextureManager.h>

#include <cstring>

#include "render/scene/ogre/Axes.h"
#include "render/scene/ogre/Part.h"

namespace sagara::render {
namespace {

const std::string& kGroup = kSceneGroup;
constexpr auto kStatic = Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY;

/// One vertex of a solid as the shader reads it.
struct PackedVertex {
    float position[3];
    float normal[3];
    std::uint32_t colour;
};
static_assert(sizeof(PackedVertex) == 28);

Ogre::SubMesh* subMeshOf(const Ogre::MeshPtr& mesh, std::size_t vertices,
                         std::span<const std::uint32_t> indices, const Ogre::MaterialPtr& material) {
    Ogre::SubMesh* sub = mesh->createSubMesh();
    sub->useSharedVertices = false;
    sub->vertexData = new Ogre::VertexData();  // OGRE deletes it
    sub->vertexData->vertexCount = vertices;
    auto buffer = Ogre::HardwareBufferManager::getSingleton().createIndexBuffer(
        Ogre::HardwareIndexBuffer::IT_32BIT, indices.size(), kStatic);
    buffer->writeData(0, indices.size_bytes(), indices.data());
    sub->indexData->indexBuffer = buffer;
    sub->indexData->indexCount = indices.size();
    sub->setMaterial(material);
    return sub;
}

void bindVertices(Ogre::SubMesh* sub, std::size_t vertexBytes, std::size_t count, const void* data) {
    auto buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(vertexBytes, count, kStatic);
    buffer->writeData(0, vertexBytes * count, data);
    sub->vertexData->vertexBufferBinding->setBinding(0, buffer);
}

Ogre::TexturePtr newTexture(const std::string& name, int width, int height, std::size_t levels,
                            Ogre::PixelFormat format, int usage) {
    return Ogre::TextureManager::getSingleton().createManual(
        name, kGroup, Ogre::TEX_TYPE_2D, static_cast<unsigned>(width), static_cast<unsigned>(height),
        static_cast<int>(levels) - 1, format, usage);
}

template <typename T>
void uploadChain(const Ogre::TexturePtr& texture, const MipChain<T>& chain, Ogre::PixelFormat format) {
    for (std::size_t n = 0; n < chain.levels.size(); ++n) {
        const auto size = static_cast<unsigned>(chain.sizes[n]);
        // OGRE's PixelBox is not const-correct; it is only read here.
        const Ogre::PixelBox box(size, size, 1, format, const_cast<T*>(chain.levels[n].data()));
        texture->getBuffer(0, n)->blitFromMemory(box);
    }
}

}  // namespace

namespace {

Ogre::MeshPtr solidMesh(const std::string& name, const Solid& solid, const Ogre::MaterialPtr& material) {
    auto mesh = Ogre::MeshManager::getSingleton().createManual(name, kGroup);
    std::vector<PackedVertex> packed;
    packed.reserve(solid.vertices.size());
    Ogre::AxisAlignedBox bounds;
    for (const SolidVertex& v : solid.vertices) {
        const Ogre::Vector3 p = ogreFromNed(v.position.x, v.position.y, -v.position.up);
        const Ogre::Vector3 n = ogreFromNed(v.normal.x, v.normal.y, -v.normal.up);
        packed.push_back({{p.x, p.y, p.z}, {n.x, n.y, n.z}, v.colour.abgr()});
        bounds.merge(p);
    }
    Ogre::SubMesh* sub = subMeshOf(mesh, packed.size(), solid.indices, material);
    auto* layout = sub->vertexData->vertexDeclaration;
    layout->addElement(0, 0, Ogre::VET_FLOAT3, Ogre::VES_POSITION);
    layout->addElement(0, 12, Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
    layout->addElement(0, 24, Ogre::VET_COLOUR_ABGR, Ogre::VES_DIFFUSE);
    bindVertices(sub, sizeof(PackedVertex), packed.size(), packed.data());
    mesh->_setBounds(bounds);
    mesh->_setBoundingSphereRadius(bounds.getHalfSize().length() + bounds.getCenter().length());
    return mesh;
}

}  // namespace

Ogre::MeshPtr meshOf(const std::string& name, const Solid& solid, const Ogre::MaterialPtr& material) {
    auto mesh = solidMesh(name, solid, material);
    mesh->load();
    return mesh;
}

Ogre::MeshPtr meshOf(const std::string& name, const TexturedSolid& textured,
                     const Ogre::MaterialPtr& material) {
    auto mesh = solidMesh(name, textured.solid, material);
    auto* data = mesh->getSubMesh(0)->vertexData;
    data->vertexDeclaration->addElement(1, 0, Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
    auto buffer = Ogre::HardwareBufferManager::getSingleton().createVertexBuffer(
        sizeof(textured.places[0]), textured.places.size(), kStatic);
    buffer->writeData(0, sizeof(textured.places[0]) * textured.places.size(), textured.places.data());
    data->vertexBufferBinding->setBinding(1, buffer);
    mesh->load();
    return mesh;
}

Ogre::MeshPtr rawMesh(const std::string& name, std::span<const float> vertices, std::size_t floatsEach,
                      std::span<const std::uint32_t> indices, const Ogre::MaterialPtr& material,
                      const Ogre::AxisAlignedBox& bounds) {
    auto mesh = Ogre::MeshManager::getSingleton().createManual(name, kGroup);
    const std::size_t count = vertices.size() / floatsEach;
    Ogre::SubMesh* sub = subMeshOf(mesh, count, indices, material);
    auto* layout = sub->vertexData->vertexDeclaration;
    layout->addElement(0, 0, Ogre::VET_FLOAT3, Ogre::VES_POSITION);
    for (std::size_t used = 3, set = 0; used < floatsEach; used += 2, ++set) {
        layout->addElement(0, 4 * used, Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES,
                           static_cast<unsigned short>(set));
    }
    bindVertices(sub, 4 * floatsEach, count, vertices.data());
    mesh->_setBounds(bounds);
    mesh->_setBoundingSphereRadius(
        bounds.isInfinite() ? 1e6f : bounds.getHalfSize().length() + bounds.getCenter().length());
    mesh->load();
    return mesh;
}

Ogre::TexturePtr floatTexture(const std::string& name, const MipChain<float>& chain) {
    return newTexture(name, chain.sizes[0], chain.sizes[0], chain.sizes.size(), Ogre::PF_FLOAT32_R,
                      Ogre::TU_DYNAMIC_WRITE_ONLY);
}
Ogre::TexturePtr byteTexture(const std::string& name, const MipChain<std::uint32_t>& chain) {
    return newTexture(name, chain.sizes[0], chain.sizes[0], chain.sizes.size(), Ogre::PF_A8B8G8R8,
                      Ogre::TU_DYNAMIC_WRITE_ONLY);
}
Ogre::TexturePtr byteTexture(const std::string& name, int width, int height,
                             const std::vector<std::uint32_t>& pixels) {
    auto texture = newTexture(name, width, height, 1, Ogre::PF_A8B8G8R8, Ogre::TU_STATIC_WRITE_ONLY);
    upload(texture, pixels);
    return texture;
}
Ogre::TexturePtr texture(const std::string& name, const TextureImage& image) {
    const auto width = static_cast<unsigned>(image.width), height = static_cast<unsigned>(image.height);
    auto made = Ogre::TextureManager::getSingleton().createManual(
        name, kGroup, Ogre::TEX_TYPE_2D, width, height, Ogre::MIP_UNLIMITED, Ogre::PF_A8B8G8R8,
        Ogre::TU_STATIC_WRITE_ONLY | Ogre::TU_AUTOMIPMAP);
    // OGRE's PixelBox is not const-correct; it is only read here.
    const Ogre::PixelBox box(width, height, 1, Ogre::PF_A8B8G8R8,
                             const_cast<std::uint32_t*>(image.abgr.data()));
    made->getBuffer()->blitFromMemory(box);
    return made;
}
void upload(const Ogre::TexturePtr& texture, const std::vector<std::uint32_t>& pixels) {
    // OGRE's PixelBox is not const-correct; it is only read here.
    const Ogre::PixelBox box(texture->getWidth(), texture->getHeight(), 1, Ogre::PF_A8B8G8R8,
                             const_cast<std::uint32_t*>(pixels.data()));
    texture->getBuffer()->blitFromMemory(box);
}
void upload(const Ogre::TexturePtr& texture, const MipChain<float>& chain) {
    uploadChain(texture, chain, Ogre::PF_FLOAT32_R);
}
void upload(const Ogre::TexturePtr& texture, const MipChain<std::uint32_t>& chain) {
    uploadChain(texture, chain, Ogre::PF_A8B8G8R8);
}

}  // namespace sagara::render
