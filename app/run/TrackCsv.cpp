#include "app/run/TrackCsv.h"

#include <fmt/format.h>

#include "core/base/Angle.h"

namespace sagara::run {

TrackCsv::TrackCsv(const core::World& world)
    : m_world(world),
      m_text(
          "time_s,ship,lat_deg,lon_deg,north_m,east_m,heave_m,roll_deg,pitch_deg,heading_deg,surge_mps,sway_"
          "mps,"
          "yaw_rate_degps,rudder_deg,shaft_rpm,depth_under_keel_m,score\n") {}

void TrackCsv::add(const core::TrackSample& sample) {
    using core::kDegree_rad;
    for (std::size_t i = 0; i < sample.ships.size(); ++i) {
        const core::ShipSample& s = sample.ships[i];
        const core::ShipMotion& m = s.motion;
        const core::GeoPoint geo = m_world.area.frame.toGeo(m.position());
        const double trueHeading_rad = m.heading_rad - m_world.area.frame.convergence_rad(m.position());
        const std::size_t shafts = m_world.ships[i]->shaftCount();
        double shaft_rps = 0.0;
        for (std::size_t k = 0; k < shafts; ++k) shaft_rps += s.shafts_rps[k] / static_cast<double>(shafts);
        m_text += fmt::format(
            "{:.2f},{},{:.7f},{:.7f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.4f},{:.2f},{:"
            ".2f},{:.2f},{:.2f}\n",
            core::timeOfTick(sample.tick).seconds(), m_world.ships[i]->id, geo.lat_deg, geo.lon_deg,
            m.north_m, m.east_m, m.down_m, m.roll_rad / kDegree_rad, m.pitch_rad / kDegree_rad,
            core::wrapTwoPi(trueHeading_rad) / kDegree_rad, m.surge_mps, m.sway_mps,
            m.yawRate_radps / kDegree_rad, s.rudder_rad / kDegree_rad, shaft_rps / core::kRpm_rps,
            s.observation.underKeel_m, s.score);
    }
}

}  // namespace sagara::run
