#include "core/seakeeping/MakeTables.h"

#include <algorithm>
#include <cmath>

#include "core/base/Archive.h"
#include "core/base/Units.h"
#include "core/seakeeping/Hydrostatics.h"
#include "core/seakeeping/LateralRadiation.h"
#include "core/seakeeping/MeanWaveForce.h"
#include "core/seakeeping/Response.h"
#include "core/seakeeping/StripTheory.h"

namespace sagara::core {
namespace {

constexpr int kEncounters = 36, kWaves = 64, kHeadings = 25;

/// Frequencies times sqrt(Lpp / g): encounter by equal ratios, waves by equal steps.
std::vector<double> encounterGrid(double lengthBp_m) {
    const double unit = std::sqrt(kGravity_mps2 / lengthBp_m);
    std::vector<double> grid;
    for (int i = 0; i < kEncounters; ++i)
        grid.push_back(unit * 0.25 * std::pow(80.0, i / (kEncounters - 1.0)));
    return grid;
}

std::vector<double> waveGrid(double lengthBp_m) {
    const double unit = std::sqrt(kGravity_mps2 / lengthBp_m);
    std::vector<double> grid;
    for (int i = 0; i < kWaves; ++i) grid.push_back(unit * (0.3 + 0.1 * i));
    return grid;
}

HullFlow flowAt(const std::vector<HullFlow>& flows, double omega_radps) {
    const auto above = std::upper_bound(flows.begin(), flows.end(), omega_radps,
                                        [](double w, const HullFlow& f) { return w < f.omega_radps; });
    if (above == flows.begin()) return flows.front();
    if (above == flows.end()) return flows.back();
    const HullFlow &low = *(above - 1), &high = *above;
    return between(low, high, (omega_radps - low.omega_radps) / (high.omega_radps - low.omega_radps));
}

std::vector<double> speedsOf(const HullForm& form, const TableOptions& options) {
    if (!options.speeds_mps.empty()) return options.speeds_mps;
    const double unit_mps = std::sqrt(kGravity_mps2 * form.lengthBp_m);
    std::vector<double> speeds;
    for (double froude = 0.0; froude < options.greatestFroude + 1e-6; froude += 0.1)
        speeds.push_back(froude * unit_mps);
    return speeds;
}

void fillWaves(const StripHull& hull, const LateralRadiation& lateral, const std::vector<HullFlow>& flows,
               bool transomTerms, SeakeepingTables& t) {
    for (const double heading : t.headings_rad)
        for (const double omega : t.waveOmega_radps)
            t.froudeKrylov.push_back(froudeKrylovForce(hull, {omega, heading, 0.0}));
    for (const double speed : t.speeds_mps) {
        for (std::size_t h = 0; h < t.headings_rad.size(); ++h) {
            for (std::size_t n = 0; n < t.waveOmega_radps.size(); ++n) {
                const MetWave wave{t.waveOmega_radps[n], t.headings_rad[h], speed};
                const HullFlow flow = flowAt(flows, std::abs(wave.encounter_radps()));
                t.diffraction.push_back(diffractionForce(hull, flow, wave, transomTerms));
                Complex6 force = t.froudeKrylov[t.waveIndex(0, h, n)];
                for (std::size_t i = 0; i < 6; ++i) {
                    const std::complex<double> sum = force[i] + t.diffraction.back()[i];
                    force.set(i, wave.encounter_radps() < 0.0 ? std::conj(sum) : sum);
                }
                const MotionEquation equation{
                    t.mass, radiationAt(lateral.of(hull, flow), flow.omega_radps, speed, transomTerms),
                    t.restoring, 0.0};
                t.meanForce.push_back(
                    meanWaveForce(hull, flow, wave, solved(equation, flow.omega_radps, force)));
            }
        }
    }
}

}  // namespace

std::uint64_t tablesHash(const HullForm& form, const TableOptions& options) {
    std::vector<double> all{static_cast<double>(SeakeepingTables::kVersion),
                            options.greatestFroude,
                            options.transomTerms ? 1.0 : 0.0,
                            form.lengthBp_m,
                            form.breadth_m,
                            form.draught_m,
                            form.waterDensity_kgpm3,
                            form.mass_kg,
                            form.gravityForward_m,
                            form.gravityHeight_m,
                            form.rollGyradius_m,
                            form.pitchGyradius_m,
                            form.yawGyradius_m,
                            form.addedRollDamping_Nms,
                            form.bilgeKeelLength_m,
                            form.bilgeKeelBreadth_m};
    all.insert(all.end(), options.speeds_mps.begin(), options.speeds_mps.end());
    for (const HullStation& s : form.stations)
        all.insert(all.end(), {s.x_m, s.breadth_m, s.draught_m, s.area_m2, s.centroid_m});
    for (const std::vector<SectionPoint>& line : form.offsets) {
        all.push_back(static_cast<double>(line.size()));
        for (const SectionPoint& p : line) all.insert(all.end(), {p.y_m, p.z_m});
    }
    return archiveHash(all);
}

IkedaShip ikedaShipOf(const HullForm& form) {
    const Hydrostatics h = hydrostaticsOf(form);
    return {form.lengthBp_m,        form.breadth_m,         form.draught_m,
            h.blockCoefficient,     h.midshipCoefficient,   form.draught_m - form.gravityHeight_m,
            form.bilgeKeelLength_m, form.bilgeKeelBreadth_m};
}

ViscousRoll viscousRollAt(const HullForm& form, double omega_radps, double speed_mps) {
    const IkedaShip ship = ikedaShipOf(form);
    const double volume_m3 = hydrostaticsOf(form).volume_m3;
    constexpr int kPoints = 10;
    double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (int i = 1; i <= kPoints; ++i) {
        const double amplitude_rad = 2.0 * i * kDegree_rad,
                     x = 8.0 / (3.0 * kPi) * omega_radps * amplitude_rad;
        const double y = viscousRollDamping_Nms(ship, form.waterDensity_kgpm3, volume_m3, amplitude_rad,
                                                omega_radps, speed_mps);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    const double slope = std::max(0.0, (kPoints * sxy - sx * sy) / (kPoints * sxx - sx * sx));
    return {std::max(0.0, (sy - slope * sx) / kPoints) + form.addedRollDamping_Nms, slope};
}

SeakeepingTables makeTables(const HullForm& form, const TableOptions& options) {
    SeakeepingTables t;
    t.inputHash = tablesHash(form, options);
    t.notes = form.notes;
    const StripHull hull = stripHullOf(form, &t.notes);
    const Hydrostatics h = hydrostaticsOf(form);
    t.lengthBp_m = form.lengthBp_m;
    t.breadth_m = form.breadth_m;
    t.draught_m = form.draught_m;
    t.volume_m3 = h.volume_m3;
    t.waterDensity_kgpm3 = form.waterDensity_kgpm3;
    t.mass_kg = form.mass_kg;
    t.centreOfGravity_B_m = {form.gravityForward_m, 0.0, form.draught_m - form.gravityHeight_m};
    t.centreOfBuoyancy_B_m = {h.buoyancyForward_m, 0.0, form.draught_m - h.buoyancyHeight_m};
    t.mass = massMatrix(form);
    t.restoring = restoringMatrix(form);
    t.omega_radps = encounterGrid(form.lengthBp_m);
    std::vector<HullFlow> flows;
    for (const double omega : t.omega_radps) flows.push_back(flowAbout(hull, omega));
    const LateralRadiation lateral(hull, flows);
    for (const HullFlow& flow : flows) t.radiation.push_back(lateral.of(hull, flow));
    t.addedMassInfinite = addedMassAtInfinity(hull);
    for (const std::size_t i : {1, 3, 5})
        for (const std::size_t j : {1, 3, 5}) t.addedMassInfinite(i, j) += lateral.atInfinity()(i, j);
    t.rollFrequency_radps = FreeRoll(form, hull, lateral).at(0.0).omega_radps;
    t.speeds_mps = speedsOf(form, options);
    for (const double speed : t.speeds_mps)
        t.viscousRoll.push_back(viscousRollAt(form, t.rollFrequency_radps, speed));
    for (int i = 0; i < kHeadings; ++i) t.headings_rad.push_back(kPi * i / (kHeadings - 1));
    t.waveOmega_radps = waveGrid(form.lengthBp_m);
    fillWaves(hull, lateral, flows, options.transomTerms, t);
    return t;
}

}  // namespace sagara::core
