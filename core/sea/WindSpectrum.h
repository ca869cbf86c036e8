#pragma once

#include <cstdint>
#include <string_view>

/// How the wind's energy lies over the frequency of its gusts, and its speed over height.
namespace sagara::core {

enum class GustSpectrum : std::uint8_t { Davenport, Harris, Kaimal, Froya };
/// "davenport", "harris", "kaimal", "froya".
std::string_view gustSpectrumName(GustSpectrum spectrum);

/// Drag coefficient of the sea surface for the wind at 10 m: Large and Pond (1981), J. Phys. Oceanogr. 11,
/// 324-336; 4 to 25 m/s, held at the ends.
double seaDragCoefficient(double wind10_mps);

/// One-sided spectral density of the speed along the mean wind, m^2/s^2 per Hz, at 10 m height:
/// Davenport (1961) 4 Cd U^2 x^2/(f (1+x^2)^(4/3)), x = 1200 f/U; Harris (1971) 4 Cd U^2 x/(f (2+x^2)^(5/6)),
/// x = 1800 f/U; Kaimal et al. (1972) 105 Cd U^2 n/(f (1+33 n)^(5/3)), n = 10 f/U; Froya (ISO 19901-1;
/// Andersen and Loevseth 1992) 320 (U/10)^2/(1+x^0.468)^(5/1.404), x = 172 f (U/10)^-0.75, 10 to 40 m/s.
double gustDensity(GustSpectrum spectrum, double frequency_Hz, double wind10_mps);

enum class WindProfile : std::uint8_t {
    Uniform,      ///< the wind at 10 m everywhere
    Power,        ///< (z/10)^0.12, open sea with waves (DNV-RP-C205)
    Logarithmic,  ///< 1 + ln(z/10)/ln(10/z0), z0 from the drag coefficient
    Froya         ///< 1 + C ln(z/10), C = 0.0573 sqrt(1 + 0.15 U), hourly mean (ISO 19901-1)
};
/// Wind at that height over the wind at 10 m. Heights below 1 m count as 1 m.
double windFactorAt(double height_m, WindProfile profile, double wind10_mps);

}  // namespace sagara::core
