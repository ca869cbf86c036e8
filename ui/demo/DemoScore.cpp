#include "ui/demo/DemoScore.h"

#include <algorithm>

#include "core/base/Units.h"

namespace sagara::ui {
namespace {

constexpr double kMoving_mps = 2.0 * core::kKnot_mps;
constexpr double kTolerated_mps = 0.5 * core::kKnot_mps;
constexpr double kMostlyInside = 0.6, kWellInside = 0.9, kMostlyMoving = 0.6, kOftenTooFast = 0.3;
constexpr double kGentle_mps = 0.3;
constexpr double kALook_s = 15.0;

}  // namespace

void DemoScore::add(double elapsed_s, const core::Snapshot& now, const Hints& hints) {
    if (now.ships.empty()) return;
    const double speed_mps = core::length(now.ships[0].overGround_mps);
    m_all_s += elapsed_s;
    m_sailed_m += elapsed_s * speed_mps;
    if (!hints.track || !hints.track->outside()) m_inside_s += elapsed_s;
    if (speed_mps >= kMoving_mps) m_moving_s += elapsed_s;
    if (hints.speedLimit_mps && speed_mps > *hints.speedLimit_mps + kTolerated_mps) m_tooFast_s += elapsed_s;
    m_aground = m_aground || now.ships[0].aground;
}

void DemoScore::happened(const core::Event& event) {
    if (event.kind == core::EventKind::Grounding) m_aground = true;
    // Lying against a fender is no harm.
    const bool gently = event.contact == core::ContactKind::Fender && event.value < kGentle_mps;
    if (event.kind == core::EventKind::Contact && !gently) m_touched = true;
}

int DemoScore::stars() const {
    if (m_all_s < kALook_s) return 1;
    int stars = 1;
    if (!spoilt()) ++stars;
    if (share(m_moving_s) >= kMostlyMoving && share(m_tooFast_s) < kOftenTooFast) ++stars;
    if (share(m_inside_s) >= kMostlyInside) ++stars;
    if (share(m_inside_s) >= kWellInside && !spoilt()) ++stars;
    return stars;
}

DemoScore::Verdict DemoScore::verdict() const {
    if (m_aground) return Verdict::RanAground;
    if (m_touched) return Verdict::Touched;
    if (m_all_s < kALook_s) return Verdict::TookALook;
    if (share(m_inside_s) < kMostlyInside) return Verdict::LeftTheChannel;
    if (share(m_tooFast_s) >= kOftenTooFast) return Verdict::TooFast;
    if (share(m_moving_s) < kMostlyMoving) return Verdict::Drifted;
    return stars() == 5 ? Verdict::Perfect : Verdict::Good;
}

}  // namespace sagara::ui
