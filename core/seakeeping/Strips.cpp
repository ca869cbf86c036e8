#include "core/seakeeping/Strips.h"

#include <algorithm>
#include <cmath>

#include "core/base/Config.h"

namespace sagara::core {
namespace {

std::string fitNote(const Strip& strip) {
    const auto number = [](double v) { return config::formatNumber(std::round(100.0 * v) / 100.0); };
    std::string note = "station at " + number(strip.x_m) + " m: no Lewis form, " + nameOf(strip.fit);
    const double off = strip.fitted.area_m2 / strip.stated.area_m2 - 1.0;
    if (std::abs(off) > 0.02) note += ", area " + number(100.0 * off) + " % off";
    return note;
}

}  // namespace

std::vector<Strip> stripsOf(const HullForm& form, std::vector<std::string>* notes) {
    std::vector<Strip> strips;
    double widest_m2 = 0.0;
    for (const HullStation& s : form.stations) widest_m2 = std::max(widest_m2, s.area_m2);
    for (std::size_t i = 0; i < form.stations.size(); ++i) {
        const HullStation& s = form.stations[i];
        Strip strip;
        strip.x_m = s.x_m;
        if (s.area_m2 < 1e-6 * widest_m2 || s.draught_m <= 0.0) {
            strips.push_back(strip);
            continue;
        }
        strip.breadth_m = s.breadth_m;
        const SectionData data{0.5 * s.breadth_m, s.draught_m, s.area_m2, form.draught_m - s.centroid_m};
        strip.stated = {data.area_m2, data.centroidDepth_m};
        if (form.offsets.empty()) {
            const SectionShape shape = shapeOf(data, kPanels);
            strip.fit = shape.fit;
            strip.panels = panelsOf(shape.nodes);
        } else {
            strip.panels = panelsOf(resampled(form.offsets[i], kPanels));
        }
        strip.fitted = areaOf(strip.panels);
        if (notes && strip.fit != SectionFit::Lewis) notes->push_back(fitNote(strip));
        strips.push_back(strip);
    }
    return strips;
}

}  // namespace sagara::core
