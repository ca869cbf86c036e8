#include "app/import/TideSource.h"

#include <cmath>

#include "app/import/TextFile.h"
#include "core/base/Config.h"
#include "core/sea/Tide.h"

namespace sagara::importer {
namespace {

using core::config::Reader;

double rounded(double value, double digits) { return std::round(value * digits) / digits; }

void keepOrName(TideConstants& tide, const TideConstants::Constituent& c, double leastAmplitude_m) {
    if (!core::isTidalConstituent(c.name)) {
        tide.unknown.push_back(c.name);
    } else if (c.amplitude_m < leastAmplitude_m) {
        tide.small.push_back(c.name);
    } else {
        tide.constituents.push_back({c.name, rounded(c.amplitude_m, 1e5), rounded(c.phaseLag_deg, 1e2)});
    }
}

TideConstants readAll(Reader& in, double leastAmplitude_m) {
    TideConstants tide;
    in.choice<bool>("amplitude_unit", {{"m", true}});
    Reader datums(in.child("datums"));
    const core::config::Range level{-100.0, 100.0, "m"};
    tide.meanAboveDatum_m = rounded(datums.number("MSL", level) - datums.number("LAT", level), 1e4);
    for (const core::config::Node& node : in.list("harmonic_constituents")) {
        Reader item(node);
        keepOrName(tide,
                   {item.text("name"), item.number("amplitude", {0.0, 10.0, "m"}),
                    item.number("phase", {-360.0, 360.0, "deg"})},
                   leastAmplitude_m);
    }
    return tide;
}

}  // namespace

TideConstants readTide(const std::filesystem::path& file, const TideRules& rules,
                       core::config::Problems& problems) {
    const auto text = readTextFile(file, problems);
    if (!text) return {};
    core::config::Document document(file.filename().string(), *text);
    Reader in(document.root());
    TideConstants tide = readAll(in, rules.leastAmplitude_m);
    if (!document.problems().empty()) problems.append(document.problems());
    return tide;
}

}  // namespace sagara::importer
