#include "app/tools/SeaTool.h"

#include <algorithm>
#include <cmath>

#include "app/files/Files.h"
#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "app/tools/Table.h"
#include "core/base/Angle.h"
#include "core/sea/Beaufort.h"
#include "core/sea/BuoySpectrum.h"
#include "core/sea/Dispersion.h"
#include "core/sea/SeaState.h"

namespace sagara::tools {
namespace {

using Systems = core::Result<std::vector<core::SeaSystem>, std::string>;

Systems measuredSea(const SeaToolOptions& o) {
    const auto text = files::readTextFile(o.file);
    if (!text) return text.error().message;
    const auto records = core::loadBuoyRecords(o.file, *text);
    if (!records) return records.error().text();
    const auto count = static_cast<int>(records->size());
    if (o.record >= count)
        return "--record: is " + std::to_string(o.record) + ", the file has 0 to " +
               std::to_string(count - 1);
    return (*records)[static_cast<std::size_t>(o.record)].systems();
}

Systems systemsAsked(const SeaToolOptions& o) {
    if (o.spectrum == "measured") return measuredSea(o);
    core::SeaOrder order = o.order;
    order.wavesTo_rad = core::wrapTwoPi(o.from_deg * core::kDegree_rad + core::kPi);
    if (o.spectrum == "beaufort") {
        const auto exposure = o.inshore ? core::Exposure::Inshore : core::Exposure::Ocean;
        const auto sea =
            core::windSea(core::windOfBeaufort_mps(o.beaufort), order.wavesTo_rad + core::kPi, exposure);
        return sea ? std::vector<core::SeaSystem>{*sea} : std::vector<core::SeaSystem>{};
    }
    for (int i = 0; i < core::kSeaSpectra; ++i) {
        order.spectrum = static_cast<core::SeaSpectrum>(i);
        if (core::seaSpectrumName(order.spectrum) == o.spectrum) break;
    }
    const bool byWind = order.spectrum == core::SeaSpectrum::PiersonMoskowitz;
    const bool byMean = order.spectrum == core::SeaSpectrum::Ittc;
    if (byWind && order.wind_mps <= 0.0)
        return std::string("--wind-mps: is missing, pierson-moskowitz goes by it");
    if (!byWind && order.significantHeight_m <= 0.0) return "--hs: is missing, " + o.spectrum + " goes by it";
    if (byMean && order.meanPeriod_s <= 0.0) return std::string("--t1: is missing, ittc goes by it");
    return core::systemsOf(order);
}

/// An hour at one place, twice a second: what a wave staff would write.
struct Surface {
    double significantHeight_m = 0.0;
    double zeroUpcrossing_s = 0.0;
    double highest_m = 0.0;
    int waves = 0;
};
Surface staff(const std::vector<core::SeaSystem>& systems, double depth_m, std::uint64_t seed) {
    const core::WaveTable table(seed, depth_m);
    core::SeaState sea{systems, {}, {}};
    core::raiseSea(table, sea);
    const core::SeaSurface surface(table, sea);
    constexpr int kSamples = 7200;
    Surface s;
    double sum2 = 0.0, before_m = 0.0, top_m = 0.0, bottom_m = 0.0, first = -1.0, last = 0.0;
    for (int i = 0; i < kSamples; ++i) {
        const double z_m = surface.elevation_m({}, core::SimTime{500'000 * std::int64_t{i}});
        sum2 += z_m * z_m;
        if (i > 0 && before_m < 0.0 && z_m >= 0.0) {
            if (first < 0.0) first = i;
            if (first < i) {
                ++s.waves;
                s.highest_m = std::max(s.highest_m, top_m - bottom_m);
            }
            last = i;
            top_m = bottom_m = 0.0;
        }
        top_m = std::max(top_m, z_m);
        bottom_m = std::min(bottom_m, z_m);
        before_m = z_m;
    }
    s.significantHeight_m = 4.0 * std::sqrt(sum2 / kSamples);
    s.zeroUpcrossing_s = s.waves > 0 ? 0.5 * (last - first) / s.waves : 0.0;
    return s;
}

Table measuresOf(const std::vector<core::SeaSystem>& systems, const SeaToolOptions& o) {
    const core::SeaStatistics s = core::statisticsOf(systems);
    const Surface surface = staff(systems, o.depth_m, o.seed);
    Table table({"name", "value"});
    table.add("hs_m", s.significantHeight_m());
    table.add("tp_s", s.peakPeriod_s);
    table.add("t1_s", s.meanPeriod_s());
    table.add("tz_s", s.zeroUpcrossing_s());
    table.add("m0_m2", s.m0_m2);
    table.add("m1_m2_radps", s.m1);
    table.add("m2_m2_rad2ps2", s.m2);
    table.add("m4_m2_rad4ps4", s.m4);
    table.add("bandwidth", s.bandwidth());
    table.add("highest_of_1000_m", s.highestOf_m(1000.0));
    table.add("wmo_sea_state", core::wmoSeaState(s.significantHeight_m()));
    table.add("surface_hs_m", surface.significantHeight_m);
    table.add("surface_tz_s", surface.zeroUpcrossing_s);
    table.add("surface_highest_m", surface.highest_m);
    table.add("surface_waves", surface.waves);
    return table;
}

Table spectrumOf(const std::vector<core::SeaSystem>& systems, const SeaToolOptions& o) {
    std::vector<double> omega = o.omega_radps;
    if (omega.empty()) {
        const double peak = core::kTwoPi / core::statisticsOf(systems).peakPeriod_s;
        for (int i = 0; i < 100; ++i) omega.push_back(peak * (1.0 / 3.0 + i * (4.0 - 1.0 / 3.0) / 99.0));
    }
    Table table({"omega_radps", "period_s", "wavelength_m", "S_m2s"});
    for (const double w : omega) {
        const double k = core::waveNumber_radpm(w, o.depth_m, core::kGravity_mps2);
        table.add({w, core::kTwoPi / w, core::kTwoPi / k, core::spectrum_m2s(systems, w)});
    }
    return table;
}

}  // namespace

int runSeaTool(const SeaToolOptions& o) {
    const auto systems = systemsAsked(o);
    if (!systems) return run::tell(systems.error()), run::kBadRequest;
    if (systems->empty()) return run::tell("there are no waves in this sea"), run::kBadRequest;
    return writeResult(o.csv, (o.measures ? measuresOf(*systems, o) : spectrumOf(*systems, o)).text());
}

}  // namespace sagara::tools
