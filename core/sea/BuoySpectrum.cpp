#include "core/sea/BuoySpectrum.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"

namespace sagara::core {
namespace {

constexpr int kWavesDocumentVersion = 1;
constexpr double kNarrowest = 100.0;  // s of the spreading; r1 = 0.99

}  // namespace

double BuoySpectrum::width_Hz(std::size_t bin) const {
    const std::size_t last = bins.size() - 1;
    const double below = bin > 0 ? bins[bin].frequency_Hz - bins[bin - 1].frequency_Hz : 0.0;
    const double above = bin < last ? bins[bin + 1].frequency_Hz - bins[bin].frequency_Hz : 0.0;
    return bin == 0 ? above : bin == last ? below : 0.5 * (below + above);
}

double BuoySpectrum::significantHeight_m() const {
    double m0_m2 = 0.0;
    for (std::size_t i = 0; i < bins.size(); ++i) m0_m2 += bins[i].energy_m2pHz * width_Hz(i);
    return 4.0 * std::sqrt(m0_m2);
}

double BuoySpectrum::peakPeriod_s() const {
    const auto peak = std::max_element(
        bins.begin(), bins.end(), [](const Bin& a, const Bin& b) { return a.energy_m2pHz < b.energy_m2pHz; });
    return peak == bins.end() ? 0.0 : 1.0 / peak->frequency_Hz;
}

double BuoySpectrum::spreading_perRad(std::size_t bin, double theta_rad) const {
    const Bin& b = bins[bin];
    return (0.5 + b.r1 * std::cos(theta_rad - b.from_rad) +
            b.r2 * std::cos(2.0 * (theta_rad - b.principal_rad))) /
           kPi;
}

std::vector<SeaSystem> BuoySpectrum::systems() const {
    std::vector<SeaSystem> systems;
    for (std::size_t i = 0; i < bins.size(); ++i) {
        const Bin& b = bins[i];
        if (b.energy_m2pHz <= 0.0) continue;
        SeaSystem s(WaveSystem{4.0 * std::sqrt(b.energy_m2pHz * width_Hz(i)), 1.0 / b.frequency_Hz, 1.0,
                               wrapTwoPi(b.from_rad + kPi), std::min(b.r1 / (1.0 - b.r1), kNarrowest)});
        s.family = SpectrumFamily::Band;
        s.form = width_Hz(i) / b.frequency_Hz;
        systems.push_back(s);
    }
    return systems;
}

BuoySpectrum readBuoySpectrum(config::Reader& in) {
    BuoySpectrum record;
    record.source = in.text("source");
    const std::vector<double> frequency_Hz = in.numbers("frequency_Hz", 0, {0.01, 2.0, "Hz"});
    const std::size_t count = frequency_Hz.size();
    if (count < 3 || count > 60)
        in.problem("frequency_Hz", "has " + std::to_string(count), "3 to 60 frequencies");
    if (!std::is_sorted(frequency_Hz.begin(), frequency_Hz.end(), std::less_equal<>()))
        in.problem("frequency_Hz", "does not grow from each to the next", "frequencies in growing order");
    const auto list = [&](const char* key, config::Range range) {
        std::vector<double> values = in.numbers(key, count, range);
        values.resize(count);
        return values;
    };
    const config::Range degrees{0.0, 360.0, "deg"};
    const std::vector<double> energy = list("energy_m2pHz", {0.0, 500.0, "m2/Hz"});
    const std::vector<double> from_deg = list("from_deg", degrees), r1 = list("r1", {0.0, 0.99, ""});
    const bool second = in.has("r2") || in.has("principal_deg");
    const std::vector<double> principal_deg =
        second ? list("principal_deg", degrees) : std::vector<double>(count);
    const std::vector<double> r2 = second ? list("r2", {0.0, 1.0, ""}) : std::vector<double>(count);
    in.rejectUnknownKeys();
    for (std::size_t i = 0; i < count; ++i) {
        record.bins.push_back({frequency_Hz[i], energy[i], kDegree_rad * from_deg[i], r1[i],
                               kDegree_rad * principal_deg[i], r2[i]});
    }
    return record;
}

Result<std::vector<BuoySpectrum>, config::Problems> loadBuoyRecords(const std::string& name,
                                                                    std::string_view text) {
    config::Document document(name, text);
    if (!document.isKind("waves", kWavesDocumentVersion)) return document.problems();
    config::Reader in(document.root());
    in.text("document");
    in.integer("version", 1, kWavesDocumentVersion);
    in.text("attribution");
    std::vector<BuoySpectrum> records;
    for (const config::Node& node : in.list("records")) {
        config::Reader record(node);
        records.push_back(readBuoySpectrum(record));
    }
    if (records.empty()) in.problem("records", "is empty", "at least one record");
    in.rejectUnknownKeys();
    return document.finish(std::move(records));
}

}  // namespace sagara::core
