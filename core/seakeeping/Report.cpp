#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/Units.h"
#include "core/seakeeping/Hydrostatics.h"
#include "core/seakeeping/Strips.h"

namespace sagara::core {
namespace {

std::string line(const char* name, double value) {
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%s,%.7g\n", name, value);
    return text.data();
}

std::vector<double> heels() {
    std::vector<double> list;
    for (int heel_deg = 5; heel_deg <= 60; heel_deg += 5) list.push_back(heel_deg * kDegree_rad);
    return list;
}

}  // namespace

std::string hydrostaticsReport(const HullForm& form) {
    std::vector<std::string> notes = form.notes;
    stripsOf(form, &notes);
    std::string report = "# " + form.name + ": x forward of midship, heights above the baseline\n";
    for (const std::string& note : notes) report += "# " + note + '\n';
    const Hydrostatics h = hydrostaticsOf(form);
    report += "name,value\n" + line("volume_m3", h.volume_m3) + line("displacement_kg", h.displacement_kg) +
              line("lcb_m", h.buoyancyForward_m) + line("kb_m", h.buoyancyHeight_m) +
              line("waterplane_m2", h.waterplane_m2) + line("lcf_m", h.flotationForward_m) +
              line("bm_transverse_m", h.transverseBM_m) + line("bm_longitudinal_m", h.longitudinalBM_m) +
              line("kg_m", form.gravityHeight_m) + line("gm_transverse_m", h.transverseGM_m) +
              line("gm_longitudinal_m", h.longitudinalGM_m) + line("cb", h.blockCoefficient) +
              line("cm", h.midshipCoefficient) + line("cw", h.waterplaneCoefficient);
    for (const RightingLever& lever : rightingLevers(form, heels())) {
        const int heel_deg = static_cast<int>(std::lround(lever.heel_rad / kDegree_rad));
        report += line(("gz_m_at_" + std::to_string(heel_deg) + "_deg").c_str(), lever.gz_m);
    }
    return report;
}

}  // namespace sagara::core
