#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// What the sea does to one vessel in one loading, worked out once by strip theory (`makeTables`) and
/// interpolated at run time: the only thing the time domain needs to know of the hull under water.
///
/// Everything is about Bo in frame B (midship, centreline, still waterline; x forward, y starboard, z down)
/// and in SI. The order of the six is surge, sway, heave, roll, pitch, yaw. Small motions about the upright
/// mean attitude, deep water. Complex amplitudes go with exp(+i w t): a positive argument is a lead.
namespace sagara::core {

/// Row-major, [6 * row + column].
struct Matrix6 {
    std::array<double, 36> value{};

    double& operator()(std::size_t row, std::size_t column) { return value[6 * row + column]; }
    double operator()(std::size_t row, std::size_t column) const { return value[6 * row + column]; }
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.value);
    }
    friend bool operator==(const Matrix6&, const Matrix6&) = default;
};

/// Six complex amplitudes: forces in N (first three) and moments in N m per metre of wave amplitude, or
/// motions.
struct Complex6 {
    std::array<double, 6> real{};
    std::array<double, 6> imaginary{};

    std::complex<double> operator[](std::size_t i) const { return {real[i], imaginary[i]}; }
    void set(std::size_t i, std::complex<double> value) {
        real[i] = value.real();
        imaginary[i] = value.imag();
    }
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.real, self.imaginary);
    }
    friend bool operator==(const Complex6&, const Complex6&) = default;
};

/// What radiated waves do at one frequency, kg, kg m, kg m2 and N s/m, N s, N m s. `end...` is the share of
/// the aftmost section per unit length (its transom, nothing where the stern is pointed): the terms of
/// forward speed need it, see `radiationAt`.
struct Radiation {
    Matrix6 addedMass;
    Matrix6 damping;
    Matrix6 endAddedMass;
    Matrix6 endDamping;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.addedMass, self.damping, self.endAddedMass, self.endDamping);
    }
    friend bool operator==(const Radiation&, const Radiation&) = default;
};

/// Roll damping that the potential flow has not: equivalent linear coefficient at roll amplitude a and
/// frequency w = linear + 8/(3 pi) w a quadratic, so the moment is -(linear + quadratic |p|) p. Fitted to
/// Ikeda's method at the natural frequency of roll over amplitudes of 2 to 20 degrees. Per speed of
/// `speeds_mps`.
struct ViscousRoll {
    double linear_Nms = 0.0;
    double quadratic_Nms2 = 0.0;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.linear_Nms, self.quadratic_Nms2);
    }
    friend bool operator==(const ViscousRoll&, const ViscousRoll&) = default;
};

/// Mean force of one wave per square metre of its amplitude, see `meanWaveForce`.
struct MeanWaveForce {
    double surge_Npm2 = 0.0;
    double sway_Npm2 = 0.0;
    double yaw_NmPm2 = 0.0;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.surge_Npm2, self.sway_Npm2, self.yaw_NmPm2);
    }
    friend bool operator==(const MeanWaveForce&, const MeanWaveForce&) = default;
};

struct SeakeepingTables {
    static constexpr std::uint32_t kVersion = 3;  ///< of this layout and of the method that fills it

    std::uint64_t inputHash = 0;  ///< of the hull, the loading, the options and kVersion: key of the cache
    double lengthBp_m = 0.0;
    double breadth_m = 0.0;
    double draught_m = 0.0;
    double volume_m3 = 0.0;
    double waterDensity_kgpm3 = 0.0;
    double mass_kg = 0.0;
    std::array<double, 3> centreOfGravity_B_m{};   ///< from Bo; z down, so negative above the waterline
    std::array<double, 3> centreOfBuoyancy_B_m{};  ///< the same
    Matrix6 mass;                                  ///< rigid body, about Bo
    Matrix6 restoring;                             ///< hydrostatic, weight included, about Bo

    std::vector<double> omega_radps;   ///< of encounter, rising; of `radiation`
    std::vector<Radiation> radiation;  ///< at zero speed
    Matrix6 addedMassInfinite;         ///< at infinite frequency, zero speed (damping is nothing there)

    std::vector<double> speeds_mps;  ///< rising from 0; of `diffraction` and `viscousRoll`
    std::vector<ViscousRoll> viscousRoll;
    double rollFrequency_radps = 0.0;     ///< natural, at zero speed
    std::vector<double> headings_rad;     ///< 0 (following) to pi (head sea), rising; of the next two
    std::vector<double> waveOmega_radps;  ///< of the wave itself in deep water, k = w^2 / g
    /// Per metre of wave whose crest passes Bo at t = 0. Relative heading mu = heading - direction the waves
    /// travel to; between pi and 2 pi (waves from port) take 2 pi - mu and change the sign of sway, roll and
    /// yaw.
    std::vector<Complex6> froudeKrylov;    ///< [heading][frequency], see `waveIndex`; the same at any speed
    std::vector<Complex6> diffraction;     ///< [speed][heading][frequency]
    std::vector<MeanWaveForce> meanForce;  ///< the same

    std::vector<std::string> notes;  ///< sections fitted otherwise than by a Lewis form, values estimated

    std::size_t waveIndex(std::size_t speed, std::size_t heading, std::size_t frequency) const {
        return (speed * headings_rad.size() + heading) * waveOmega_radps.size() + frequency;
    }
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.inputHash, self.lengthBp_m, self.breadth_m, self.draught_m, self.volume_m3,
           self.waterDensity_kgpm3, self.mass_kg, self.centreOfGravity_B_m, self.centreOfBuoyancy_B_m,
           self.mass, self.restoring, self.omega_radps, self.radiation, self.addedMassInfinite,
           self.speeds_mps, self.viscousRoll, self.rollFrequency_radps, self.headings_rad,
           self.waveOmega_radps, self.froudeKrylov, self.diffraction, self.meanForce, self.notes);
    }
    friend bool operator==(const SeakeepingTables&, const SeakeepingTables&) = default;
};

/// At speed ahead, about Bo.
struct AddedMassAndDamping {
    Matrix6 addedMass;
    Matrix6 damping;
};
/// Added mass and damping at the speed ahead U and encounter frequency w > 0, from those at zero speed
/// (Salvesen, Tuck and Faltinsen 1970, SNAME 78, 250-287, eq. 24 to 35 with the terms of the aftmost section,
/// if wanted).
AddedMassAndDamping radiationAt(const Radiation& zeroSpeed, double omega_radps, double speed_mps,
                                bool transomTerms);

}  // namespace sagara::core
