#pragma once

#include <OgreMatrix3.h>
#include <OgreQuaternion.h>
#include <OgreVector.h>

#include "render/scene/Camera.h"

/// The one place where frame N (north, east, down) becomes OGRE's axes: x east, y up, z south.
namespace sagara::render {

inline Ogre::Vector3 ogreFromNed(double north, double east, double down) {
    return {static_cast<float>(east), static_cast<float>(-down), static_cast<float>(-north)};
}

/// Turns what looks along its own -z, with x to the right and y up: a camera.
inline Ogre::Quaternion ogreAttitude(const Camera& camera) {
    const CameraAxes a = axesOf(camera);
    Ogre::Matrix3 axes;
    axes.FromAxes(ogreFromNed(a.right[0], a.right[1], a.right[2]), ogreFromNed(a.up[0], a.up[1], a.up[2]),
                  -ogreFromNed(a.forward[0], a.forward[1], a.forward[2]));
    return Ogre::Quaternion(axes);
}

/// The same for a model built with x to starboard, y up, z astern, as the ship lies in N.
inline Ogre::Quaternion ogreAttitude(double heading_rad, double pitch_rad, double roll_rad) {
    Camera ship;
    ship.heading_rad = heading_rad;
    ship.pitch_rad = pitch_rad;
    ship.roll_rad = roll_rad;
    return ogreAttitude(ship);
}

/// A place in N as seen from an eye: the difference is taken in double.
inline Ogre::Vector3 relativeTo(const Camera& eye, core::NorthEast p, double up_m) {
    return ogreFromNed(p.north_m - eye.position.north_m, p.east_m - eye.position.east_m, eye.up_m - up_m);
}

}  // namespace sagara::render
