#pragma once

#include <OgreManualObject.h>

#include "render/scene/ogre/Part.h"

namespace sagara::render {

/// A point of light, drawn as a soft disc of so many pixels.
struct Sprite {
    Ogre::Vector3 place;  ///< relative to the eye
    Colour colour;        ///< times its brightness
    double width_px = 2.0;
    double height_px = 2.0;
};

/// Points of light drawn together; filled anew when they change.
class Sprites {
public:
    Sprites(Ogre::SceneManager& scenes, const ShaderMaterial& material);
    void fill(const std::vector<Sprite>& sprites);
    Ogre::SceneNode& node() { return *m_node; }

private:
    Ogre::ManualObject* m_object;
    Ogre::SceneNode* m_node;
    std::string m_material;
    bool m_begun = false;
};

}  // namespace sagara::render
