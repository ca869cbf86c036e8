#include "core/vessel/Plausible.h"

#include <algorithm>
#include <cmath>

#include "core/vessel/Metacentre.h"

namespace sagara::core {
namespace {

/// Three figures are what a person needs to see what went wrong.
double rounded(double value) {
    if (value == 0.0) return 0.0;
    const double scale = std::pow(10.0, 2.0 - std::floor(std::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}
std::string figure(double value) { return config::formatNumber(rounded(value)); }

class Checker {
public:
    explicit Checker(config::Reader& in) : m_in(in) {}

    void within(const std::string& path, double value, double low, double high, const std::string& because) {
        if (value >= low && value <= high) return;
        m_in.problem(path, "is " + config::formatNumber(value),
                     figure(low) + " to " + figure(high) + " " + because);
    }
    /// A place of gear or machinery, with a little room for what stands over the side.
    void aboard(const std::string& path, const BodyPoint& p, const Hull& hull) {
        const double along_m = 0.55 * hull.lengthOverall_m, across_m = 0.6 * hull.beam_m;
        within(path + ".x_m", p.x_m, -along_m, along_m, "m, inside the ship");
        within(path + ".y_m", p.y_m, -across_m, across_m, "m, inside the ship");
    }

private:
    config::Reader& m_in;
};

/// Area under a curve over the stations; straight between them, nothing beyond.
double alongStations(const std::vector<HullStation>& stations, double HullStation::*value) {
    double sum = 0.0;
    for (std::size_t i = 1; i < stations.size(); ++i)
        sum += 0.5 * (stations[i].x_m - stations[i - 1].x_m) * (stations[i].*value + stations[i - 1].*value);
    return sum;
}

void checkForm(Checker& check, const Hull& h) {
    if (!h.stations.empty()) {
        const double volume_m3 = alongStations(h.stations, &HullStation::area_m2),
                     plane = alongStations(h.stations, &HullStation::breadth_m) / (h.lengthBp_m * h.beam_m);
        check.within("hull.displacement_m3", h.displacement_m3, 0.85 * volume_m3, 1.15 * volume_m3,
                     "m3, by the stations");
        check.within("hull.waterplaneCoefficient", h.waterplaneCoefficient, 0.85 * plane,
                     std::min(1.0, 1.15 * plane), "by the stations");
    }
    const double block = h.blockCoefficient();
    check.within("hull.waterplaneCoefficient", h.waterplaneCoefficient, 0.95 * block, 1.0,
                 "with a block coefficient of " + figure(block));
    check.within("hull.depth_m", h.depth_m, h.draught_m, std::max(h.beam_m, 6.0 * h.draught_m),
                 "m with a draught of " + figure(h.draught_m) + " m");
    check.within("hull.draught_m", h.draught_m, 0.05 * h.beam_m, 1.5 * h.beam_m,
                 "m with a beam of " + figure(h.beam_m) + " m");
    check.within("hull.beam_m", h.beam_m, h.lengthBp_m / 25.0, h.lengthBp_m,
                 "m with a length of " + figure(h.lengthBp_m) + " m");
}

void checkLoading(Checker& check, const Hull& h) {
    // Morrish and the waterplane's inertia are good to a tenth; G in the keel is what no cargo does.
    check.within("hull.metacentricHeight_m", h.metacentricHeight_m, 0.05, 1.15 * metacentre_m(h),
                 "m, or the centre of gravity is below the keel");
    check.within("hull.rollGyradius_m", h.rollGyradius_m, 0.2 * h.beam_m, 0.6 * h.beam_m,
                 "m, 0.2 to 0.6 of the beam");
    check.within("hull.pitchGyradius_m", h.pitchGyradius_m, 0.15 * h.lengthBp_m, 0.4 * h.lengthBp_m,
                 "m, 0.15 to 0.4 of lengthBp_m");
}

std::string item(const char* list, std::size_t i) {
    return std::string(list).append("[").append(std::to_string(i)).append("]");
}

void checkMachinery(Checker& check, const Vessel& v) {
    const Hull& h = v.hull;
    for (std::size_t i = 0; i < v.propulsion.units.size(); ++i) {
        const std::string path = item("propulsion.units", i);
        check.within(path + ".diameter_m", v.propulsion.units[i].diameter_m, 0.1 * h.draught_m,
                     1.2 * h.draught_m, "m with a draught of " + figure(h.draught_m) + " m");
        check.aboard(path, v.propulsion.units[i].position, h);
    }
    const double lateral_m2 = h.lengthBp_m * h.draught_m;
    for (std::size_t i = 0; i < v.steering.rudders.size(); ++i)
        check.aboard(item("steering.rudders", i), v.steering.rudders[i], h);
    if (!v.steering.rudders.empty())
        check.within("steering.areaEach_m2", v.steering.areaEach_m2, 0.001 * lateral_m2, 0.15 * lateral_m2,
                     "m2, 0.1 to 15 % of length by draught");
    for (std::size_t i = 0; i < v.thrusters.units.size(); ++i) {
        const std::string path = item("thrusters.units", i);
        check.aboard(path, v.thrusters.units[i].position, h);
        check.within(path + ".height_m", v.thrusters.units[i].height_m, -1.2 * h.draught_m, 0.0,
                     "m, below the water and above the keel");
    }
}

void checkDeck(Checker& check, const Vessel& v) {
    check.aboard("bridgeEye", v.bridgeEye, v.hull);
    for (std::size_t i = 0; i < v.mooring.fairleads.size(); ++i)
        check.aboard(item("mooring.fairleads", i), v.mooring.fairleads[i].position, v.hull);
    for (std::size_t i = 0; i < v.groundTackle.anchors.size(); ++i)
        check.aboard(item("groundTackle.anchors", i), v.groundTackle.anchors[i].hawse, v.hull);
}

/// The side force astern is that of one screw: of two that turn against each other nothing is left.
void checkAstern(config::Reader& document, const Vessel& v) {
    for (const NamedModel& m : v.models) {
        const auto* mmg = std::get_if<MmgModel>(&m.parameters);
        if (mmg && !mmg->astern.empty() && v.propulsion.units.size() > 1)
            document.problem("models",
                             "has \"astern\" in \"" + m.name + "\" with " +
                                 std::to_string(v.propulsion.units.size()) + " propulsion.units",
                             "\"astern\" for a single screw only");
    }
}

}  // namespace

void checkPlausible(config::Reader& document, const Vessel& v) {
    Checker check(document);
    checkForm(check, v.hull);
    checkLoading(check, v.hull);
    checkMachinery(check, v);
    checkDeck(check, v);
    checkAstern(document, v);
    if (v.planing) checkPlaningHull(document, *v.planing, v.hull);
}

}  // namespace sagara::core
