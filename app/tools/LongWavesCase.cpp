#include <cmath>

#include "app/tools/CaseRows.h"
#include "app/tools/HullChoice.h"
#include "core/base/Units.h"
#include "core/seakeeping/Response.h"

namespace sagara::tools {
namespace {

/// A hull at rest in waves of ten times a natural period.
double sizeIn(const core::HullForm& form, double natural_radps, double heading_rad, std::size_t motion) {
    const core::MetWave wave{0.1 * natural_radps, heading_rad, 0.0};
    const core::WaveResponse r = core::HullResponse(form).respond(wave, form.lengthBp_m / 1000.0);
    return std::abs(r.atGravity[motion]) / (motion < 3 ? 1.0 : wave.waveNumber_radpm());
}

}  // namespace

/// Long waves carry a ship as they carry a cork: heave is the wave, roll and pitch are its slope.
ValidationOutcome runLongWavesCase(const ValidationContext& context, core::config::Reader& in) {
    const std::vector<std::string> hulls = in.texts("hulls");
    const double share = readShare(in, "share");
    in.rejectUnknownKeys();
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    for (const std::string& hull : hulls) {
        const auto form = readHullFile(context.reference(hull).string());
        if (!form) return outcome.trouble = form.error(), outcome;
        const double heave_radps = 0.9 * std::sqrt(core::kGravity_mps2 / (2.0 * form->draught_m));
        const auto add = [&](const char* motion, double size) {
            outcome.rows.push_back({.quantity = form->name + ": " + motion,
                                    .measured = size,
                                    .reference = 1.0,
                                    .tolerance = share,
                                    .share = true});
        };
        add("heave, head waves", sizeIn(*form, heave_radps, core::kPi, 2));
        add("pitch, head waves", sizeIn(*form, heave_radps, core::kPi, 4));
        add("heave, beam waves", sizeIn(*form, heave_radps, 0.5 * core::kPi, 2));
        if (const core::RollMode roll = core::FreeRoll(*form).at(0.01); roll.omega_radps > 0.0)
            add("roll, beam waves", sizeIn(*form, roll.omega_radps, 0.5 * core::kPi, 3));
    }
    return outcome;
}

}  // namespace sagara::tools
