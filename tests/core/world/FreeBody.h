#pragma once

#include "core/base/SimTime.h"
#include "core/motion/RungeKutta.h"
#include "core/world/Contact.h"

namespace sagara::core::test {

/// A rigid hull without water round it: what contact does to it is all that happens to it.
struct FreeBody {
    FreeBody(double lengthOverall_m, double beam_m, double bodyMass_kg)
        : mass_kg(bodyMass_kg), inertia_kgm2(bodyMass_kg * lengthOverall_m * lengthOverall_m / 16.0) {
        Hull form;
        form.lengthOverall_m = lengthOverall_m;
        form.beam_m = beam_m;
        form.displacement_m3 = bodyMass_kg;
        form.waterDensity_kgpm3 = 1.0;
        hull = contactHull(form, bodyMass_kg);
    }
    double mass_kg, inertia_kgm2;
    ContactHull hull;
    ShipMotion motion;

    HeadingFrame frame() const { return {motion.position(), motion.heading_rad}; }
    NorthEast velocity() const { return frame().vector({motion.surge_mps, motion.sway_mps}); }
    void setVelocity(NorthEast v_mps) {
        const BodyPoint body = frame().vectorInBody(v_mps);
        motion.surge_mps = body.x_m;
        motion.sway_mps = body.y_m;
    }
    double energy_J() const {
        const double v = motion.surge_mps, w = motion.sway_mps, r = motion.yawRate_radps;
        return 0.5 * mass_kg * (v * v + w * w) + 0.5 * inertia_kgm2 * r * r;
    }
    /// Farthest that an outline point lies south of `north_m`.
    double southOf_m(double north_m) const {
        double deepest_m = 0.0;
        for (const BodyPoint& p : hull.outline)
            deepest_m = std::max(deepest_m, north_m - frame().point(p).north_m);
        return deepest_m;
    }

    void tick(const Obstacles& obstacles) {
        motion = rk4Step(motion, kTick_s, [&](const ShipMotion& m) {
            const Load load = contactLoad(obstacles, hull, m, {});
            const NorthEast v = HeadingFrame({}, m.heading_rad).vector({m.surge_mps, m.sway_mps});
            ShipMotion rate;
            rate.north_m = v.north_m;
            rate.east_m = v.east_m;
            rate.heading_rad = m.yawRate_radps;
            rate.surge_mps = load.surge_N / mass_kg + m.sway_mps * m.yawRate_radps;
            rate.sway_mps = load.sway_N / mass_kg - m.surge_mps * m.yawRate_radps;
            rate.yawRate_radps = load.yaw_Nm / inertia_kgm2;
            return rate;
        });
    }
    void tick(const Area& area) {
        Obstacles found;
        findObstacles(area, hull, motion, found);
        tick(found);
    }
};

}  // namespace sagara::core::test
