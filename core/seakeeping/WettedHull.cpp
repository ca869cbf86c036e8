#include "core/seakeeping/WettedHull.h"

#include <algorithm>
#include <cmath>

#include "core/base/Trig.h"
#include "core/base/Units.h"
#include "core/seakeeping/Strips.h"

namespace sagara::core {
namespace {

constexpr int kSidePanels = 10;        ///< of a half section: area is enough here
constexpr double kSmall_rad = 1e-4;    ///< for the slope of the moment
constexpr double kMostHeel_rad = 1.4;  ///< against the surface: beyond, as there

}  // namespace

WettedHull::WettedHull(const HullForm& form)
    : m_weight_Npm3(form.waterDensity_kgpm3 * kGravity_mps2),
      m_gravityMoment_Nm(form.mass_kg * kGravity_mps2 * (form.gravityHeight_m - form.draught_m)) {
    for (const Strip& strip : stripsOf(form)) {
        if (strip.panels.empty()) continue;
        Station s{
            strip.x_m,       0.0, wholeSection(resampled(strip.outline, kSidePanels), form.freeboard_m), 0.0,
            strip.breadth_m, 0.0};
        s.area_m2 = wettedSection(s.section, 0.0, 0.0).area_m2;
        s.momentPerHeel_m3 = wettedSection(s.section, kSmall_rad, 0.0).moment_m3 / kSmall_rad;
        m_stations.push_back(std::move(s));
    }
    double area_m2 = 0.0, volume_m3 = 0.0;
    for (std::size_t i = 0; i < m_stations.size(); ++i) {
        const double before = m_stations[i > 0 ? i - 1 : 0].x_m,
                     after = m_stations[std::min(i + 1, m_stations.size() - 1)].x_m;
        m_stations[i].weight_m = 0.5 * (after - before);
        area_m2 += m_stations[i].weight_m * m_stations[i].breadth_m;
        volume_m3 += m_stations[i].weight_m * m_stations[i].area_m2;
    }
    if (m_stations.empty()) return;
    m_meanDepth_m = area_m2 > 0.0 ? volume_m3 / area_m2 : form.draught_m;
    m_aft_m = m_stations.front().x_m;
    m_step_m = (m_stations.back().x_m - m_aft_m) / static_cast<double>(kSteps);
}

WettedHull::Surfaces WettedHull::surfaces(const ActiveWaves& waves, const HullAttitude& at,
                                          double shelter) const {
    const double c = std::cos(at.heading_rad), s = std::sin(at.heading_rad);
    Surfaces all{};
    for (std::size_t n = 0; n < waves.count; ++n) {
        const double kN = waves.kNorth_radpm[n], kE = waves.kEast_radpm[n];
        const double along = kN * c + kE * s, across = kE * c - kN * s;
        const double height =
            shelter * waves.amplitude_m[n] * std::exp(-std::sqrt(kN * kN + kE * kE) * m_meanDepth_m);
        const double start =
            kN * at.position.north_m + kE * at.position.east_m + waves.phase_rad[n] + along * m_aft_m;
        SinCos wave = sinCos(start);
        const SinCos turn = sinCos(along * m_step_m);
        for (Surface& surface : all) {
            surface.level_m += height * wave.cos;
            surface.slope -= height * across * wave.sin;
            wave = {wave.sin * turn.cos + wave.cos * turn.sin, wave.cos * turn.cos - wave.sin * turn.sin};
        }
    }
    return all;
}

WettedHull::Surface WettedHull::between(const Surfaces& all, double x_m) const {
    const double place = (x_m - m_aft_m) / m_step_m;
    const auto low = static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(kSteps) - 1.0));
    const double share = place - static_cast<double>(low);
    const Surface &a = all[low], &b = all[low + 1];
    return {a.level_m + share * (b.level_m - a.level_m), a.slope + share * (b.slope - a.slope)};
}

Six WettedHull::correction(const ActiveWaves& waves, const HullAttitude& at, double shelter) const {
    Six more{};
    if (m_stations.size() < 2) return more;
    const Surfaces all = surfaces(waves, at, shelter);
    for (const Station& s : m_stations) {
        const Surface sea = between(all, s.x_m);
        const double level_m = sea.level_m + at.down_m - s.x_m * at.pitch_rad;
        const double heel_rad = std::clamp(at.roll_rad + std::atan(sea.slope), -kMostHeel_rad, kMostHeel_rad);
        const WettedSection wet = wettedSection(s.section, heel_rad, level_m);
        const double area_m2 = wet.area_m2 - s.area_m2 - s.breadth_m * level_m;
        const double moment_m3 = wet.moment_m3 - s.momentPerHeel_m3 * heel_rad;
        more[2] -= m_weight_Npm3 * s.weight_m * area_m2;
        more[3] -= m_weight_Npm3 * s.weight_m * moment_m3;
        more[4] += m_weight_Npm3 * s.weight_m * s.x_m * area_m2;
    }
    more[3] += m_gravityMoment_Nm * (std::sin(at.roll_rad) - at.roll_rad);
    return more;
}

}  // namespace sagara::core
