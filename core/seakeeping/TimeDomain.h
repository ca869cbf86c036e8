#pragma once

#include "core/seakeeping/FloatingHull.h"
#include "core/seakeeping/HullForm.h"
#include "core/seakeeping/Response.h"
#include "core/seakeeping/WaveExcitation.h"

namespace sagara::core {

/// Responses measured by running a hull through regular waves in six degrees of freedom. Each run begins with
/// the motion that comes back to itself after one encounter, found by Newton's method on the run of one
/// period (shooting): nothing needs to die out, and motions that nothing holds (surge, and sway and yaw of a
/// hull without a rudder) stay in bounds. Amplitude and phase are then those of the first harmonic.
class TimeDomainHull {
public:
    explicit TimeDomainHull(const HullForm& form, const TableOptions& options = {});

    /// As HullResponse::respond; forces, memory and stiffness from the tables only.
    WaveResponse respond(const MetWave& wave, double waveHeight_m) const;
    const SeakeepingTables& tables() const { return m_tables; }

private:
    HullForm m_form;
    SeakeepingTables m_tables;
    FloatingHull m_hull;
    WaveExcitation m_excitation;
};

/// `raoTable` measured in the time domain.
std::string timeDomainRaoTable(const HullForm& form, double speed_mps, double relativeHeading_rad,
                               const std::vector<double>& omegas_radps, std::optional<double> waveHeight_m,
                               const TableOptions& options = {});

}  // namespace sagara::core
