#include "core/seakeeping/StripTheory.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/base/Units.h"
#include "core/sea/Dispersion.h"
#include "core/seakeeping/Hydrostatics.h"

namespace sagara::core {
namespace {

using Complex = std::complex<double>;

// Inside: x forward, y to port, z up, as Salvesen, Tuck and Faltinsen have it; half a turn about x makes it
// frame B.
constexpr std::array<double, 6> kToFrameB{1.0, -1.0, -1.0, 1.0, -1.0, -1.0};

Matrix6 toFrameB(Matrix6 m) {
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) m(i, j) *= kToFrameB[i] * kToFrameB[j];
    return m;
}

/// Six modes from the three of a section: pitch is heave times -x, yaw is sway times x.
struct Mode {
    std::size_t at;
    int section;  ///< 2 sway, 3 heave, 4 roll
    int power;
    double sign;
};
constexpr std::array<Mode, 5> kModes{
    {{1, 2, 0, 1.0}, {2, 3, 0, 1.0}, {3, 4, 0, 1.0}, {4, 3, 1, -1.0}, {5, 2, 1, 1.0}}};

double coefficient(const SectionCoefficients& c, int i, int j) {
    if (i == j) return i == 2 ? c.sway_m2 : i == 3 ? c.heave_m2 : c.roll_m4;
    return i + j == 6 ? c.swayRoll_m3 : 0.0;
}

/// Sections integrated along the hull; `end` the aftmost one alone.
struct Integrated {
    Matrix6 whole;
    Matrix6 end;
};

Integrated integrated(const StripHull& hull, const std::vector<SectionCoefficients>& sections) {
    Integrated sum;
    std::vector<double> values(sections.size());
    for (const Mode& a : kModes) {
        for (const Mode& b : kModes) {
            for (std::size_t i = 0; i < sections.size(); ++i)
                values[i] = coefficient(sections[i], a.section, b.section);
            const double factor = hull.waterDensity_kgpm3 * a.sign * b.sign;
            sum.whole(a.at, b.at) = factor * alongStations(hull.x_m, values, a.power + b.power);
            sum.end(a.at, b.at) = factor * values[0] * std::pow(hull.x_m[0], a.power + b.power);
        }
    }
    return sum;
}

void addSurge(const StripHull& hull, Matrix6& addedMass) {
    const double z_m = -hull.buoyancyDepth_m;
    addedMass(0, 0) += hull.surgeAddedMass_kg;
    addedMass(0, 4) += hull.surgeAddedMass_kg * z_m;
    addedMass(4, 0) += hull.surgeAddedMass_kg * z_m;
    addedMass(4, 4) += hull.surgeAddedMass_kg * z_m * z_m;
}

std::vector<Complex> mixed(const std::vector<Complex>& a, const std::vector<Complex>& b, double share) {
    std::vector<Complex> list(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) list[i] = a[i] + share * (b[i] - a[i]);
    return list;
}

SectionFlow sectionFlow(const Strip& strip, double waveNumber_radpm) {
    return strip.panels.empty() ? SectionFlow{} : flowAbout(strip.panels, waveNumber_radpm);
}

}  // namespace

StripHull stripHullOf(const HullForm& form, std::vector<std::string>* notes) {
    StripHull hull;
    hull.strips = stripsOf(form, notes);
    for (const Strip& s : hull.strips) hull.x_m.push_back(s.x_m);
    hull.waterDensity_kgpm3 = form.waterDensity_kgpm3;
    const Hydrostatics floating = hydrostaticsOf(form);
    hull.volume_m3 = floating.volume_m3;
    hull.buoyancyDepth_m = form.draught_m - floating.buoyancyHeight_m;
    // Soeding (1982), Schiffstechnik 29, 3-29.
    hull.surgeAddedMass_kg = 2.7 * form.waterDensity_kgpm3 * std::pow(floating.volume_m3, 5.0 / 3.0) /
                             std::pow(form.lengthBp_m, 2);
    return hull;
}

HullFlow flowAbout(const StripHull& hull, double omega_radps) {
    HullFlow flow{omega_radps, {}};
    for (const Strip& strip : hull.strips)
        flow.strips.push_back(sectionFlow(strip, deepWaveNumber_radpm(omega_radps, kGravity_mps2)));
    return flow;
}

HullFlow between(const HullFlow& low, const HullFlow& high, double share) {
    HullFlow flow{low.omega_radps + share * (high.omega_radps - low.omega_radps), {}};
    for (std::size_t i = 0; i < low.strips.size(); ++i) {
        const SectionFlow &a = low.strips[i], &b = high.strips[i];
        flow.strips.push_back({mixed(a.sway_m, b.sway_m, share), mixed(a.heave_m, b.heave_m, share),
                               mixed(a.roll_m2, b.roll_m2, share)});
    }
    return flow;
}

Radiation radiationOf(const StripHull& hull, const HullFlow& flow) {
    std::vector<SectionCoefficients> added, damped;
    for (std::size_t i = 0; i < hull.strips.size(); ++i) {
        const SectionRadiation section = radiationOf(hull.strips[i].panels, flow.strips[i]);
        added.push_back(section.addedMass);
        SectionCoefficients b = section.dampingOverOmega;
        for (double* value : {&b.sway_m2, &b.heave_m2, &b.roll_m4, &b.swayRoll_m3})
            *value *= flow.omega_radps;
        damped.push_back(b);
    }
    Integrated a = integrated(hull, added);
    const Integrated b = integrated(hull, damped);
    addSurge(hull, a.whole);
    return {toFrameB(a.whole), toFrameB(b.whole), toFrameB(a.end), toFrameB(b.end)};
}

Matrix6 addedMassAtInfinity(const StripHull& hull) {
    std::vector<SectionCoefficients> added;
    for (const Strip& strip : hull.strips)
        added.push_back(
            radiationOf(strip.panels, sectionFlow(strip, std::numeric_limits<double>::infinity())).addedMass);
    Matrix6 a = integrated(hull, added).whole;
    addSurge(hull, a);
    return toFrameB(a);
}

double MetWave::waveNumber_radpm() const { return deepWaveNumber_radpm(omega_radps, kGravity_mps2); }

double MetWave::encounter_radps() const {
    return omega_radps - waveNumber_radpm() * speed_mps * std::cos(relativeHeading_rad);
}

Matrix6 massMatrix(const HullForm& form) {
    const double m = form.mass_kg, x = form.gravityForward_m, z = form.gravityHeight_m - form.draught_m;
    Matrix6 M;
    M(0, 0) = M(1, 1) = M(2, 2) = m;
    M(0, 4) = M(4, 0) = m * z;
    M(1, 3) = M(3, 1) = -m * z;
    M(1, 5) = M(5, 1) = m * x;
    M(2, 4) = M(4, 2) = -m * x;
    M(3, 3) = m * (std::pow(form.rollGyradius_m, 2) + z * z);
    M(4, 4) = m * (std::pow(form.pitchGyradius_m, 2) + z * z + x * x);
    M(5, 5) = m * (std::pow(form.yawGyradius_m, 2) + x * x);
    M(3, 5) = M(5, 3) = -m * x * z;
    return toFrameB(M);
}

Matrix6 restoringMatrix(const HullForm& form) {
    const Hydrostatics h = hydrostaticsOf(form);
    const double weight = kGravity_mps2 * form.waterDensity_kgpm3;
    const double lever_m = h.buoyancyHeight_m - form.gravityHeight_m;
    Matrix6 C;
    C(2, 2) = weight * h.waterplane_m2;
    C(2, 4) = C(4, 2) = -weight * h.waterplane_m2 * h.flotationForward_m;
    C(3, 3) = weight * (h.transverseInertia_m4 + h.volume_m3 * lever_m);
    C(4, 4) = weight * (h.longitudinalInertia_m4 + h.waterplane_m2 * std::pow(h.flotationForward_m, 2) +
                        h.volume_m3 * lever_m);
    return toFrameB(C);
}

}  // namespace sagara::core
