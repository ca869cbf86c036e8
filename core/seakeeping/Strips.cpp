#include "core/seakeeping/Strips.h"

#include <algorithm>
#include <cmath>

#include "core/base/Config.h"

namespace sagara::core {
namespace {

std::string number(double value) { return config::formatNumber(std::round(100.0 * value) / 100.0); }

/// One line for each way of fitting, with its stations.
void tellFits(const std::vector<Strip>& strips, std::vector<std::string>& notes) {
    for (const SectionFit fit :
         {SectionFit::RoundedBox, SectionFit::Skeg, SectionFit::Bulb, SectionFit::Plain}) {
        std::string places;
        for (const Strip& strip : strips) {
            if (strip.fit != fit || strip.panels.empty()) continue;
            places += (places.empty() ? "" : ", ") + number(strip.x_m);
            const SectionArea outline = areaOf(panelsOf(strip.outline));
            const double off = 100.0 * (outline.area_m2 / strip.stated.area_m2 - 1.0);
            if (std::abs(off) > 2.0) places += " (area " + number(off) + " % off)";
            const double lower_m = outline.depth_m - strip.stated.depth_m;
            if (std::abs(lower_m) > kCentroidBand * -strip.outline.front().z_m)
                places += " (centroid " + number(lower_m) + " m lower)";
        }
        if (!places.empty())
            notes.push_back(std::string("no Lewis form but ") + nameOf(fit) + " at x = " + places + " m");
    }
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
            strip.outline = shape.nodes;
        } else {
            strip.outline = resampled(form.offsets[i], kPanels);
        }
        strip.panels = panelsOf(thickened(strip.outline));
        strip.fitted = areaOf(strip.panels);
        strips.push_back(strip);
    }
    if (notes) tellFits(strips, *notes);
    return strips;
}

}  // namespace sagara::core
