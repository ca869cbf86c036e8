#pragma once

#include <string_view>
#include <vector>

#include "core/sea/Spectrum.h"

namespace sagara::core {

/// Spectra a sea can be ordered by.
enum class SeaSpectrum : std::uint8_t { PiersonMoskowitz, Bretschneider, Ittc, Jonswap, OchiHubble };
inline constexpr int kSeaSpectra = 5;
/// "pierson-moskowitz", "bretschneider", "ittc", "jonswap", "ochi-hubble".
std::string_view seaSpectrumName(SeaSpectrum spectrum);

/// A sea as a person orders it. Which of height, periods and wind are used depends on the spectrum:
/// PiersonMoskowitz the wind, Ittc height and mean period, OchiHubble the height alone, the others height and
/// peak period.
struct SeaOrder {
    SeaSpectrum spectrum = SeaSpectrum::Jonswap;
    double significantHeight_m = 0.0;
    double peakPeriod_s = 8.0;
    double meanPeriod_s = 0.0;  ///< T1
    double gamma = 3.3;         ///< Jonswap only
    double wind_mps = 0.0;      ///< at 10 m, PiersonMoskowitz only
    double wavesTo_rad = 0.0;
    double spreading = 4.0;
    SpreadingLaw law = SpreadingLaw::Cos2s;
};
/// The trains it is made of: one, or Ochi and Hubble's two.
std::vector<SeaSystem> systemsOf(const SeaOrder& order);

/// Height and peak of a fully developed sea: Hs = 0.21 V^2/g, wp = 0.877 g/V, V at 19.5 m = 1.026 of the wind
/// at 10 m (Pierson and Moskowitz 1964).
struct HeightAndPeak {
    double significantHeight_m = 0.0;
    double peakPeriod_s = 0.0;
};
HeightAndPeak fullyDeveloped(double wind10_mps);

/// Moments m_n = integral of w^n S and what is read from them. The frequencies are 0.02 to 30 rad/s.
struct SeaStatistics {
    double m0_m2 = 0.0;
    double m1 = 0.0;  ///< m^2 rad/s
    double m2 = 0.0;  ///< m^2 rad^2/s^2
    double m4 = 0.0;  ///< m^2 rad^4/s^4, to four times the peak's frequency (it has no limit of its own)
    double peakPeriod_s = 0.0;

    double significantHeight_m() const;  ///< 4 sqrt m0
    double meanPeriod_s() const;         ///< T1 = 2 pi m0/m1
    double zeroUpcrossing_s() const;     ///< Tz = 2 pi sqrt(m0/m2)
    double bandwidth() const;            ///< epsilon of Cartwright and Longuet-Higgins (1956)
    /// Most probable highest wave, crest to trough, of so many: Rayleigh.
    double highestOf_m(double waves) const;
};
SeaStatistics statisticsOf(const std::vector<SeaSystem>& systems);
double spectrum_m2s(const std::vector<SeaSystem>& systems, double omega_radps);

/// WMO code table 3700: 0 calm (glassy) to 9 phenomenal.
int wmoSeaState(double significantHeight_m);

}  // namespace sagara::core
