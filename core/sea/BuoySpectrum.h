#pragma once

#include <string>
#include <vector>

#include "core/base/Config.h"
#include "core/sea/Spectrum.h"

namespace sagara::core {

/// One record of a directional wave buoy in the form the NDBC publishes: energy by frequency and the first
/// two Fourier coefficients of its spreading over direction.
struct BuoySpectrum {
    struct Bin {
        double frequency_Hz = 0.0;
        double energy_m2pHz = 0.0;
        double from_rad = 0.0;  ///< mean direction alpha1, true, where the waves come from
        double r1 = 0.0;
        double principal_rad = 0.0;  ///< alpha2
        double r2 = 0.0;
    };
    std::string source;  ///< station and time
    std::vector<Bin> bins;

    /// Width of a bin: half way to its neighbours; the first and the last reach as far out as in.
    double width_Hz(std::size_t bin) const;
    double significantHeight_m() const;  ///< 4 sqrt(integral E df)
    double peakPeriod_s() const;         ///< of the bin with the most energy per Hz
    /// (1/pi) (1/2 + r1 cos(theta - alpha1) + r2 cos 2(theta - alpha2)), NDBC (1996); can be negative.
    /// theta_rad: where the waves come from.
    double spreading_perRad(std::size_t bin, double theta_rad) const;
    /// One Band each for every bin with energy, spread by cos^2s with s = r1/(1 - r1) (Longuet-Higgins et al.
    /// 1963), which has the same r1 and is nowhere negative.
    std::vector<SeaSystem> systems() const;
};

/// "source", "frequency_Hz", "energy_m2pHz", "from_deg", "r1" and, together or not at all, "principal_deg"
/// and "r2": lists of one length.
BuoySpectrum readBuoySpectrum(config::Reader& in);

/// The records of a "waves" document (assets/waves), newest last.
Result<std::vector<BuoySpectrum>, config::Problems> loadBuoyRecords(const std::string& name,
                                                                    std::string_view text);

}  // namespace sagara::core
