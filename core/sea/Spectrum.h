#pragma once

/// Wave spectra S(omega) in m^2 s per radian and their spreading over direction. Definitions: ITTC 1978
/// (Bretschneider), Hasselmann et al. 1973 with the DNV normalisation (JONSWAP).
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

/// Two-parameter spectrum of a fully developed sea: Pierson-Moskowitz form with given height and peak.
double bretschneider_m2s(double omega_radps, double significantHeight_m, double peakPeriod_s);

/// JONSWAP with factor (1 - 0.287 ln gamma), which keeps the height within 0.2 % up to gamma 5.
double jonswap_m2s(double omega_radps, double significantHeight_m, double peakPeriod_s, double gamma);

/// D(theta) per radian, integral over a turn = 1. theta is measured from the mean direction.
double spreading_perRad(double theta_rad, double s);

/// Peak period over mean period T1 = 2 pi m0 / m1: interpolated between integrated spectra, gamma 1 to 5,
/// within 1 %.
double peakOverMeanPeriod(double gamma);

}  // namespace sagara::core
