#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/Units.h"
#include "core/seakeeping/TimeDomain.h"

namespace sagara::core {
namespace {

constexpr std::array<const char*, 6> kMotions{"surge", "sway", "heave", "roll", "pitch", "yaw"};

std::string cell(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

std::string rowOf(const WaveResponse& r, double lengthBp_m) {
    const double waveNumber_radpm = kTwoPi / (r.lambdaOverL * lengthBp_m);
    std::string row = cell(r.omega_radps) + ',' + cell(r.encounter_radps) + ',' + cell(r.lambdaOverL);
    for (std::size_t i = 0; i < 6; ++i)
        row += ',' + cell(std::abs(r.atGravity[i]) / (i < 3 ? 1.0 : waveNumber_radpm));
    for (std::size_t i = 0; i < 6; ++i) row += ',' + cell(std::arg(r.atGravity[i]) / kDegree_rad);
    return row + '\n';
}

/// By whatever answers to waves.
std::string measured(const auto& ship, const HullForm& form, double speed_mps, double relativeHeading_rad,
                     const std::vector<double>& omegas_radps, std::optional<double> waveHeight_m) {
    const double height_m = waveHeight_m.value_or(form.lengthBp_m / 50.0);
    std::vector<WaveResponse> responses;
    for (const double omega_radps : omegas_radps)
        responses.push_back(ship.respond({omega_radps, relativeHeading_rad, speed_mps}, height_m));
    return raoTable(responses, form.lengthBp_m);
}

}  // namespace

std::string raoTable(const std::vector<WaveResponse>& responses, double lengthBp_m) {
    std::string table = "omega_radps,omega_e_radps,lambda_over_L";
    for (std::size_t i = 0; i < 6; ++i) table += std::string(",") + kMotions[i] + (i < 3 ? "" : "_k");
    for (const char* motion : kMotions) table += std::string(",") + motion + "_phase_deg";
    table += '\n';
    for (const WaveResponse& r : responses) table += rowOf(r, lengthBp_m);
    return table;
}

std::string raoTable(const HullForm& form, double speed_mps, double relativeHeading_rad,
                     const std::vector<double>& omegas_radps, std::optional<double> waveHeight_m,
                     const TableOptions& options) {
    return measured(HullResponse(form, options), form, speed_mps, relativeHeading_rad, omegas_radps,
                    waveHeight_m);
}

std::string timeDomainRaoTable(const HullForm& form, double speed_mps, double relativeHeading_rad,
                               const std::vector<double>& omegas_radps, std::optional<double> waveHeight_m,
                               const TableOptions& options) {
    TableOptions here = options;
    here.speeds_mps = {speed_mps};
    return measured(TimeDomainHull(form, here), form, speed_mps, relativeHeading_rad, omegas_radps,
                    waveHeight_m);
}

}  // namespace sagara::core
