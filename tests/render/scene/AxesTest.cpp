#include "render/scene/ogre/Axes.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"

namespace sagara::render {
namespace {

void expectSame(const Ogre::Vector3& a, const Ogre::Vector3& b) {
    EXPECT_LT((a - b).length(), 1e-6f) << a << " and " << b;
}

TEST(Axes, NorthEastDownBecomeAwayRightBelow) {
    EXPECT_EQ(ogreFromNed(1.0, 0.0, 0.0), Ogre::Vector3(0, 0, -1));
    EXPECT_EQ(ogreFromNed(0.0, 1.0, 0.0), Ogre::Vector3(1, 0, 0));
    EXPECT_EQ(ogreFromNed(0.0, 0.0, 1.0), Ogre::Vector3(0, -1, 0));
}

TEST(Axes, BothFramesAreRightHanded) {
    const Ogre::Vector3 n = ogreFromNed(1, 0, 0), e = ogreFromNed(0, 1, 0), d = ogreFromNed(0, 0, 1);
    EXPECT_EQ(n.crossProduct(e), d);
}

TEST(Axes, AShipOnAnEasterlyHeadingPointsHerBowEast) {
    const Ogre::Quaternion q = ogreAttitude(90.0 * core::kDegree_rad, 0.0, 0.0);
    expectSame(q * Ogre::Vector3(0, 0, -1), ogreFromNed(0, 1, 0));
    expectSame(q * Ogre::Vector3(1, 0, 0), ogreFromNed(-1, 0, 0));  // starboard is south
}

TEST(Axes, BowUpAndStarboardDownAreThat) {
    EXPECT_GT((ogreAttitude(0.3, 0.1, 0.0) * Ogre::Vector3(0, 0, -1)).y, 0.09f);
    EXPECT_LT((ogreAttitude(0.3, 0.0, 0.1) * Ogre::Vector3(1, 0, 0)).y, -0.09f);
}

TEST(Axes, ACentimetreStaysACentimetreFarFromTheDatum) {
    Camera eye;
    eye.position = {90'000.01, -80'000.02};
    eye.up_m = 10.0;
    expectSame(relativeTo(eye, {90'000.02, -80'000.0}, 10.0), ogreFromNed(0.01, 0.02, 0.0));
}

}  // namespace
}  // namespace sagara::render
