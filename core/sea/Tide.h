#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/SimTime.h"
#include "core/base/Utc.h"

namespace sagara::core {

/// Harmonic constants of one place, as published: amplitude and Greenwich phase lag.
struct TidalConstituent {
    std::string name;  ///< "M2", "K1", ...; see isTidalConstituent
    double amplitude_m = 0.0;
    double phaseLag_rad = 0.0;
};

/// Whether the astronomical argument of this constituent is known here.
bool isTidalConstituent(std::string_view name);
/// Names known, for messages.
std::string tidalConstituentNames();

/// Height of tide during one exercise: h(t) = z0 + sum f H cos(V + u - g), Schureman (1958), Special
/// Publication 98. Astronomical longitudes: Meeus (1998), chapters 22, 25 and 47; node factors: Pugh (1987),
/// table 4:3. f and u are those of the start: they change by 0.01 % a day.
class TidePrediction {
public:
    TidePrediction() = default;  ///< no tide
    TidePrediction(double meanAboveDatum_m, const std::vector<TidalConstituent>& constituents, Utc start);
    /// Above chart datum.
    double height_m(SimTime time) const;

private:
    struct Term {
        double amplitude_m;
        double speed_radps;
        double phase_rad;
    };
    double m_mean_m = 0.0;
    std::vector<Term> m_terms;
};

}  // namespace sagara::core
