#include "core/seakeeping/WaveExcitation.h"

#include <algorithm>
#include <cmath>

#include "core/base/Trig.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

/// Lagrange through the points -1, 0, 1 and 2.
std::array<double, 4> cubicWeights(double t) {
    return {-t * (t - 1.0) * (t - 2.0) / 6.0, (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
            -(t + 1.0) * t * (t - 2.0) / 2.0, (t + 1.0) * t * (t - 1.0) / 6.0};
}

constexpr bool isOdd(std::size_t motion) { return motion == 1 || motion == 3 || motion == 5; }
/// All but heave go with the slope of a long wave: they are kept over the wave number, so that straight lines
/// do for long waves too.
constexpr bool goesWithSlope(std::size_t motion) { return motion != 2; }

using Parts = std::array<double, 16>;

/// The tables over heading and frequency at one of their speeds, evened out for interpolation.
class Slice {
public:
    Slice(const SeakeepingTables& tables, std::size_t speed) : m_t(tables), m_speed(speed) {}

    /// Force in a wave of the frequency; what is odd in heading over the sine of it.
    Parts at(double omega_radps, double cosine) const {
        const double first = m_t.waveOmega_radps.front(), second = m_t.waveOmega_radps[1];
        if (omega_radps >= first) return overFrequency(omega_radps, cosine);
        // What long waves add to the static force goes with the square of the frequency, and the next term of
        // it with the fourth.
        const Parts low = overFrequency(first, cosine), high = overFrequency(second, cosine);
        Parts parts{};
        const double w2 = omega_radps * omega_radps, first2 = first * first, second2 = second * second;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const double still = i < 6 ? -m_t.restoring(i, 2) : 0.0;
            const double a = (low[i] - still) / first2, b = (high[i] - still) / second2;
            parts[i] = still + w2 * (a + (w2 - first2) * (b - a) / (second2 - first2));
        }
        return parts;
    }

private:
    Parts overFrequency(double omega_radps, double cosine) const {
        const std::vector<double>& grid = m_t.waveOmega_radps;
        const double step = (grid.back() - grid.front()) / static_cast<double>(grid.size() - 1);
        const double place = (omega_radps - grid.front()) / step;
        const auto last = static_cast<double>(grid.size()) - 3.0;
        const double low = std::clamp(std::floor(place), 1.0, last);
        const std::array<double, 4> w = cubicWeights(place - low);
        Parts sum{};
        for (std::size_t n = 0; n < 4; ++n) {
            const Parts p = overHeading(static_cast<std::size_t>(low) + n - 1, cosine);
            for (std::size_t i = 0; i < p.size(); ++i) sum[i] += w[n] * p[i];
        }
        return sum;
    }
    Parts overHeading(std::size_t frequency, double cosine) const {
        const std::size_t steps = m_t.headings_rad.size() - 1;
        const double place = std::acos(std::clamp(cosine, -1.0, 1.0)) / kPi * static_cast<double>(steps);
        const double low = std::min(std::floor(place), static_cast<double>(steps) - 1.0);
        const std::array<double, 4> w = cubicWeights(place - low);
        Parts sum{};
        for (int n = 0; n < 4; ++n) {
            const Parts p = atGrid(frequency, static_cast<int>(low) + n - 1);
            for (std::size_t i = 0; i < p.size(); ++i) sum[i] += w[static_cast<std::size_t>(n)] * p[i];
        }
        return sum;
    }
    /// Even in heading about both ends. Over the sine there is nothing at the ends themselves: from the two
    /// next to them, as of a parabola.
    Parts atGrid(std::size_t frequency, int heading) const {
        const int steps = static_cast<int>(m_t.headings_rad.size()) - 1;
        if (heading < 0) heading = -heading;
        if (heading > steps) heading = 2 * steps - heading;
        Parts parts = ofTables(frequency, static_cast<std::size_t>(heading));
        if (heading > 0 && heading < steps) return parts;
        const int inward = heading == 0 ? 1 : -1;
        const Parts a = ofTables(frequency, static_cast<std::size_t>(heading + inward)),
                    b = ofTables(frequency, static_cast<std::size_t>(heading + 2 * inward));
        for (std::size_t i = 0; i < 6; ++i) {
            if (!isOdd(i)) continue;
            parts[i] = (4.0 * a[i] - b[i]) / 3.0;
            parts[6 + i] = (4.0 * a[6 + i] - b[6 + i]) / 3.0;
        }
        for (const std::size_t i : {13U, 14U}) parts[i] = (4.0 * a[i] - b[i]) / 3.0;
        return parts;
    }
    Parts ofTables(std::size_t frequency, std::size_t heading) const {
        const Complex6 &fk = m_t.froudeKrylov[m_t.waveIndex(0, heading, frequency)],
                       &d = m_t.diffraction[m_t.waveIndex(m_speed, heading, frequency)];
        const double sine = std::sin(m_t.headings_rad[heading]);
        const double over = sine > 1e-9 ? 1.0 / sine : 0.0;
        Parts parts{};
        for (std::size_t i = 0; i < 6; ++i) {
            const double factor = isOdd(i) ? over : 1.0;
            parts[i] = factor * (fk.real[i] + d.real[i]);
            parts[6 + i] = factor * (fk.imaginary[i] + d.imaginary[i]);
        }
        const MeanWaveForce& mean = m_t.meanForce[m_t.waveIndex(m_speed, heading, frequency)];
        parts[12] = mean.surge_Npm2;
        parts[13] = over * mean.sway_Npm2;
        parts[14] = over * mean.yaw_NmPm2;
        return parts;
    }

    const SeakeepingTables& m_t;
    std::size_t m_speed;
};

/// Velocity of the water in a wave, at half the draught and as its mean along the ship, over that at the
/// surface at Bo.
double meanVelocity(const SeakeepingTables& t, double omega_radps, double cosine) {
    const double k = omega_radps * omega_radps / kGravity_mps2, X = 0.5 * k * cosine * t.lengthBp_m;
    return std::exp(-0.5 * k * t.draught_m) * (std::abs(X) < 1e-3 ? 1.0 : std::sin(X) / X);
}

}  // namespace

WaveExcitation::WaveExcitation(const SeakeepingTables& tables)
    : m_stillPitch_Nm(-tables.restoring(4, 2)), m_speeds_mps(tables.speeds_mps) {
    const std::vector<double>& grid = tables.waveOmega_radps;
    const double step = (grid.back() - grid.front()) / static_cast<double>((grid.size() - 1) * kRefined);
    const auto inside = static_cast<std::size_t>(grid.back() / step) + 1;
    const double fade = 0.2 * grid.back();
    m_frequencies = inside + static_cast<std::size_t>(fade / step) + 2;
    m_perFrequency = 1.0 / step;
    m_shortest_radpm = std::pow(step * static_cast<double>(m_frequencies - 1), 2) / kGravity_mps2;
    m_cosineStride = m_frequencies * kParts;
    m_speedStride = m_cosineStride * kCosines;
    m_table.reserve(m_speedStride * tables.speeds_mps.size());
    for (std::size_t s = 0; s < tables.speeds_mps.size(); ++s) {
        const Slice slice(tables, s);
        for (std::size_t c = 0; c < kCosines; ++c) {
            const double cosine = 2.0 * static_cast<double>(c) / (kCosines - 1.0) - 1.0;
            for (std::size_t n = 0; n < m_frequencies; ++n) {
                const double omega = step * std::max(1e-3, static_cast<double>(n));
                const double over = std::clamp((omega - grid.back()) / fade, 0.0, 1.0);
                Parts parts = slice.at(std::min(omega, grid.back()), cosine);
                parts[15] = meanVelocity(tables, omega, cosine);
                for (std::size_t i = 0; i < 12; ++i) parts[i] *= 1.0 - over;
                parts[4] -= m_stillPitch_Nm;
                for (std::size_t i = 0; i < 12; ++i)
                    if (goesWithSlope(i % 6)) parts[i] /= omega * omega / kGravity_mps2;
                for (const double part : parts) m_table.push_back(static_cast<float>(part));
            }
        }
    }
    if (tables.speeds_mps.size() >= 4) fillBetween();
}

/// More speeds between those of the tables, evenly spaced: from ahead to the beam by the cubic through the
/// four nearest; abaft it by straight lines, because the forces turn where the ship begins to overtake the
/// waves.
void WaveExcitation::fillBetween() {
    const std::size_t given = m_speeds_mps.size(), wanted = (given - 1) * kBetween + 1;
    const std::vector<float> table = std::move(m_table);
    const double step = m_speeds_mps[1] / kBetween;
    const std::size_t forward = (kCosines / 2 + 1) * m_cosineStride;
    m_speeds_mps.clear();
    m_table.assign(wanted * m_speedStride, 0.0F);
    for (std::size_t s = 0; s < wanted; ++s) {
        m_speeds_mps.push_back(step * static_cast<double>(s));
        const std::size_t low = std::clamp<std::size_t>(s / kBetween, 1, given - 3);
        const std::array<double, 4> w =
            cubicWeights(static_cast<double>(s) / kBetween - static_cast<double>(low));
        for (std::size_t n = 0; n < 4; ++n) {
            const auto weight = static_cast<float>(w[n]);
            const float* const from = table.data() + (low + n - 1) * m_speedStride;
            float* const to = m_table.data() + s * m_speedStride;
            for (std::size_t i = 0; i < forward; ++i) to[i] += weight * from[i];
        }
        const std::size_t below = std::min(s / kBetween, given - 2);
        const auto share = static_cast<float>(static_cast<double>(s) / kBetween - static_cast<double>(below));
        const float *const slow = table.data() + below * m_speedStride, *const fast = slow + m_speedStride;
        for (std::size_t i = forward; i < m_speedStride; ++i)
            m_table[s * m_speedStride + i] = slow[i] + share * (fast[i] - slow[i]);
    }
}

std::size_t WaveExcitation::speedBelow(double speed_mps, double& share) const {
    share = 0.0;
    if (m_speeds_mps.size() < 2) return 0;
    std::size_t low = 0;
    while (low + 2 < m_speeds_mps.size() && m_speeds_mps[low + 1] <= speed_mps) ++low;
    share =
        std::clamp((speed_mps - m_speeds_mps[low]) / (m_speeds_mps[low + 1] - m_speeds_mps[low]), 0.0, 1.0);
    return low;
}

WaveExcitation::Place WaveExcitation::placeOf(double waveNumber_radpm, double cosine, std::size_t speed,
                                              double speedShare) const {
    const double most = static_cast<double>(m_frequencies - 1);
    const double n = std::min(std::sqrt(kGravity_mps2 * waveNumber_radpm) * m_perFrequency, most);
    const double c = std::clamp(0.5 * (cosine + 1.0), 0.0, 1.0) * (kCosines - 1.0);
    const auto nLow = std::min(static_cast<std::size_t>(n), m_frequencies - 2);
    const auto cLow = std::min(static_cast<std::size_t>(c), kCosines - 2);
    const auto u = static_cast<float>(speedShare), v = static_cast<float>(c - static_cast<double>(cLow)),
               w = static_cast<float>(n - static_cast<double>(nLow));
    const float u0 = 1.0F - u, v0 = 1.0F - v, w0 = 1.0F - w;
    return {
        speed * m_speedStride + cLow * m_cosineStride + nLow * kParts,
        {u0 * v0 * w0, u0 * v0 * w, u0 * v * w0, u0 * v * w, u * v0 * w0, u * v0 * w, u * v * w0, u * v * w}};
}

void WaveExcitation::blend(const Place& place, double* parts) const {
    const float* const low = m_table.data() + place.first;
    const float* const faster = m_speeds_mps.size() < 2 ? low : low + m_speedStride;
    const float* const corner[] = {
        low,    low + kParts,    low + m_cosineStride,    low + m_cosineStride + kParts,
        faster, faster + kParts, faster + m_cosineStride, faster + m_cosineStride + kParts};
    for (std::size_t i = 0; i < kParts; ++i) {
        float sum = 0.0F;
        for (std::size_t k = 0; k < 8; ++k) sum += place.weight[k] * corner[k][i];
        parts[i] = static_cast<double>(sum);
    }
}

Complex6 WaveExcitation::amplitude(double waveNumber_radpm, double relativeHeading_rad,
                                   double speed_mps) const {
    if (waveNumber_radpm >= m_shortest_radpm) return {};
    double share = 0.0;
    const std::size_t speed = speedBelow(speed_mps, share);
    double parts[kParts];
    blend(placeOf(waveNumber_radpm, std::cos(relativeHeading_rad), speed, share), parts);
    Complex6 force;
    for (std::size_t i = 0; i < 6; ++i) {
        const double factor =
            (isOdd(i) ? std::sin(relativeHeading_rad) : 1.0) * (goesWithSlope(i) ? waveNumber_radpm : 1.0);
        force.set(i, {factor * parts[i] + (i == 4 ? m_stillPitch_Nm : 0.0), factor * parts[6 + i]});
    }
    return force;
}

WaveForces WaveExcitation::force(const ActiveWaves& waves, NorthEast position, double heading_rad,
                                 double speed_mps, double shelter) const {
    const double c = std::cos(heading_rad), s = std::sin(heading_rad);
    double share = 0.0;
    const std::size_t speed = speedBelow(speed_mps, share);
    WaveForces sum;
    for (std::size_t n = 0; n < waves.count; ++n) {
        const double kNorth = waves.kNorth_radpm[n], kEast = waves.kEast_radpm[n];
        const double k = std::sqrt(kNorth * kNorth + kEast * kEast);
        if (k <= 0.0 || k >= m_shortest_radpm) continue;
        double parts[kParts];
        blend(placeOf(k, (kNorth * c + kEast * s) / k, speed, share), parts);
        // Height cos(a) is the real part of exp(-i a), and time goes with exp(+i w t).
        const SinCos wave = sinCos(kNorth * position.north_m + kEast * position.east_m + waves.phase_rad[n]);
        const double height = waves.amplitude_m[n], slope = height * k,
                     across = height * (kNorth * s - kEast * c);
        const double factor[] = {slope, across, height, across, slope, across};
        for (std::size_t i = 0; i < 6; ++i)
            sum.first[i] += factor[i] * (parts[i] * wave.cos + parts[6 + i] * wave.sin);
        sum.first[4] += height * m_stillPitch_Nm * wave.cos;
        sum.mean[0] += height * height * parts[12];
        sum.mean[1] += height * across / k * parts[13];
        sum.mean[5] += height * across / k * parts[14];
        // At the surface in water of any depth: g k / omega times the height, along the wave.
        const double perSlope = parts[15] * kGravity_mps2 / waves.omega_radps[n] * wave.cos;
        sum.waterSurge_mps += height * perSlope * (kNorth * c + kEast * s);
        sum.waterSway_mps -= across * perSlope;
    }
    sum.waterSurge_mps *= shelter;
    sum.waterSway_mps *= shelter;
    for (double& value : sum.first) value *= shelter;
    for (double& value : sum.mean) value *= shelter * shelter;
    return sum;
}

}  // namespace sagara::core
