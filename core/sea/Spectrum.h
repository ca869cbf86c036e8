#pragma once

#include <cstdint>

/// Wave spectra S(omega) in m^2 s per radian and their spreading over direction. Definitions: ITTC 1978
/// (Bretschneider), Hasselmann et al. 1973 with the DNV normalisation (JONSWAP), Ochi and Hubble 1976.
namespace sagara::core {

/// One train of waves: a wind sea or a swell.
struct WaveSystem {
    double significantHeight_m = 0.0;
    double peakPeriod_s = 8.0;
    double gamma = 1.0;        ///< JONSWAP peakedness; 1 is Pierson-Moskowitz (Bretschneider) form
    double wavesTo_rad = 0.0;  ///< mean direction of travel
    double spreading = 4.0;    ///< s of cos^2s(theta/2): about 4 for a wind sea, 20 to 70 for swell

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.significantHeight_m, self.peakPeriod_s, self.gamma, self.wavesTo_rad, self.spreading);
    }
    friend bool operator==(const WaveSystem&, const WaveSystem&) = default;
};

enum class SpectrumFamily : std::uint8_t {
    Jonswap,     ///< with gamma 1: Pierson-Moskowitz form
    OchiHubble,  ///< one of the two parts of the six-parameter spectrum
    Band         ///< even energy between two frequencies: a bin of a measured spectrum
};
enum class SpreadingLaw : std::uint8_t {
    Cos2s,  ///< cos^2s(theta/2) over the whole turn
    CosN    ///< cos^n(theta) over the half turn ahead, n = `spreading`
};

/// A train of waves with any shape of spectrum, as it runs in the sea of this moment.
struct SeaSystem : WaveSystem {
    SpectrumFamily family = SpectrumFamily::Jonswap;
    SpreadingLaw law = SpreadingLaw::Cos2s;
    double form = 1.0;  ///< OchiHubble: lambda. Band: its width over its middle frequency

    SeaSystem() = default;
    SeaSystem(const WaveSystem& system) : WaveSystem(system) {}
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        WaveSystem::fields(ar, self);
        ar(self.family, self.law, self.form);
    }
    friend bool operator==(const SeaSystem&, const SeaSystem&) = default;
};
/// S(omega) of the system.
double spectrum_m2s(const SeaSystem& system, double omega_radps);
/// D(theta) of the system per radian, theta from its mean direction.
double spreading_perRad(const SeaSystem& system, double theta_rad);

/// Two-parameter spectrum of a fully developed sea: Pierson-Moskowitz form with given height and peak.
double bretschneider_m2s(double omega_radps, double significantHeight_m, double peakPeriod_s);
/// The same by mean period T1, with the ITTC's rounded constants: A w^-5 exp(-B w^-4), A = 173 Hs^2/T1^4,
/// B = 691/T1^4 (ITTC 1978).
double ittc_m2s(double omega_radps, double significantHeight_m, double meanPeriod_s);

/// JONSWAP with factor (1 - 0.287 ln gamma), which keeps the height within 0.2 % up to gamma 5.
double jonswap_m2s(double omega_radps, double significantHeight_m, double peakPeriod_s, double gamma);
/// ITTC's form of it by mean period: 155 Hs^2/(T1^4 w^5) exp(-944/(T1^4 w^4)) 3.3^Y (ITTC 1984).
double ittcJonswap_m2s(double omega_radps, double significantHeight_m, double meanPeriod_s);

/// One part of Ochi and Hubble (1976), Proc. 15th Coastal Eng. Conf., 301-328, eq. 7; lambda 1 is
/// Bretschneider's form.
double ochiHubble_m2s(double omega_radps, double significantHeight_m, double peakPeriod_s, double lambda);

/// D(theta) per radian of cos^2s(theta/2), integral over a turn = 1. theta is measured from the mean
/// direction.
double spreading_perRad(double theta_rad, double s);
/// D(theta) per radian of cos^n(theta) within a quarter turn to each side, 0 beyond; n = 2: (2/pi) cos^2.
double halfPlaneSpreading_perRad(double theta_rad, double n);

/// Peak period over mean period T1 = 2 pi m0 / m1: interpolated between integrated spectra, gamma 1 to 5,
/// within 1 %.
double peakOverMeanPeriod(double gamma);

}  // namespace sagara::core
