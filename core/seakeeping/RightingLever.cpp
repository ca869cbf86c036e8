#include <algorithm>
#include <cmath>

#include "core/seakeeping/Hydrostatics.h"
#include "core/seakeeping/Strips.h"
#include "core/seakeeping/WettedSection.h"

namespace sagara::core {
std::vector<RightingLever> rightingLevers(const HullForm& form, const std::vector<double>& heels_rad) {
    std::vector<double> x_m;
    std::vector<SectionPolygon> sections;
    for (const Strip& strip : stripsOf(form)) {
        if (strip.panels.empty()) continue;
        x_m.push_back(strip.x_m);
        sections.push_back(wholeSection(strip.outline, form.freeboard_m));
    }
    const auto under = [&](double heel_rad, double level_m) {
        std::vector<double> area_m2, moment_m3;
        for (const SectionPolygon& section : sections) {
            const WettedSection wet = wettedSection(section, heel_rad, level_m);
            area_m2.push_back(wet.area_m2);
            moment_m3.push_back(wet.moment_m3);
        }
        return WettedSection{alongStations(x_m, area_m2, 0), alongStations(x_m, moment_m3, 0)};
    };
    const double volume_m3 = under(0.0, 0.0).area_m2;
    const auto crossCurve_m = [&](double heel_rad) {
        double low_m = -form.draught_m - form.breadth_m, high_m = form.freeboard_m + form.breadth_m;
        for (int i = 0; i < 50; ++i) {
            const double level_m = 0.5 * (low_m + high_m);
            (under(heel_rad, level_m).area_m2 < volume_m3 ? low_m : high_m) = level_m;
        }
        return under(heel_rad, low_m).moment_m3 / volume_m3;
    };
    // The fitted sections begin to heel about a metacentre of their own: by its height they are put right.
    constexpr double kSmall_rad = 0.01;
    const Hydrostatics h = hydrostaticsOf(form);
    const double metacentre_m = h.buoyancyHeight_m + h.transverseBM_m - form.draught_m;
    const double off_m = metacentre_m - crossCurve_m(kSmall_rad) / std::sin(kSmall_rad);
    std::vector<RightingLever> levers;
    for (const double heel_rad : heels_rad) {
        const double gravity_m = form.gravityHeight_m - form.draught_m;
        levers.push_back({heel_rad, crossCurve_m(heel_rad) + (off_m - gravity_m) * std::sin(heel_rad)});
    }
    return levers;
}

}  // namespace sagara::core
