#include "render/scene/rope/Ropes.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/world/Catenary.h"
#include "render/scene/ship/ShipForm.h"

namespace sagara::render {
namespace {

constexpr Paint kRopePaint{0.90, 0.87, 0.76};
constexpr Paint kCablePaint{0.16, 0.15, 0.14};
constexpr int kSpans = 12;               // of a line between its ends
constexpr double kUnderWater_m = 1.2;    // as deep as a wave may bare it
constexpr double kBollardHead_m = 2.25;  // above mean sea level: the quay at 1.9 m, and what stands on it
constexpr double kChock_m = 0.25;        // a fairlead above the deck

/// 40 mm polyester breaks at 220 kN and weighs 1 kg/m; others in proportion (ISO 1141).
double lineDiameter_m(const core::MooringGear& gear) { return 0.04 * std::sqrt(gear.breakingLoad_N / 220e3); }
double lineWeight_Npm(double diameter_m) { return core::kGravity_mps2 * 625.0 * diameter_m * diameter_m; }
/// Studlink weighs 0.0219 d^2 kg/m by its bar in millimetres (ISO 1704); links are 3.6 d broad, every other
/// one is seen on edge.
double cableBreadth_m(const core::AnchorGear& gear) { return 3.0 * std::sqrt(gear.cableMass_kgpm / 21.9e3); }

Rope straightDown(PlaceUp from, double down_m, double diameter_m, Paint paint) {
    return {{from, {from.position, from.up_m - down_m}}, diameter_m, paint};
}

Rope mooringLine(const core::MooringGear& gear, double length_m, PlaceUp fairlead, PlaceUp bollard) {
    const core::NorthEast across = bollard.position - fairlead.position;
    const double drop_m = fairlead.up_m - bollard.up_m;
    const double span_m = std::max(0.5, std::hypot(core::length(across), drop_m));
    // The dynamics measure a line in the plane; drawn it also climbs.
    const double drawn_m = std::max(1.0, length_m) * span_m / std::max(0.5, core::length(across));
    Rope rope{{}, lineDiameter_m(gear), kRopePaint};
    const double hang_m = sag_m(span_m, drawn_m, lineWeight_Npm(rope.diameter_m), gear.stiffness_N);
    for (int i = 0; i <= kSpans; ++i) {
        const double t = static_cast<double>(i) / kSpans;
        rope.points.push_back(
            {fairlead.position + t * across, fairlead.up_m - t * drop_m - 4.0 * hang_m * t * (1.0 - t)});
    }
    return rope;
}

Rope anchorCable(const core::AnchorGear& gear, const core::AnchorState& anchor, PlaceUp hawse,
                 double water_m) {
    const double toWater_m = hawse.up_m + kUnderWater_m;
    const double breadth_m = cableBreadth_m(gear);
    const double apart_m = core::distance(hawse.position, anchor.position);
    if (!anchor.onBottom || apart_m < 0.1)
        return straightDown(hawse, std::min(anchor.cableOut_m, std::max(0.0, toWater_m)), breadth_m,
                            kCablePaint);
    const double weight_Npm = core::cableWeight_Npm(gear);
    const core::CableShape shape =
        core::cableShape(apart_m, std::max(0.5, hawse.up_m + water_m), std::max(0.5, anchor.cableOut_m),
                         weight_Npm, core::cableStiffness_N(gear));
    const core::NorthEast outwards = (1.0 / apart_m) * (anchor.position - hawse.position);
    Rope rope{{}, breadth_m, kCablePaint};
    for (const CablePoint& p :
         hangingCable(shape.horizontal_N, shape.atHawse_N, weight_Npm, std::max(0.1, toWater_m))) {
        if (p.out_m > apart_m) break;
        rope.points.push_back({hawse.position + p.out_m * outwards, hawse.up_m - p.down_m});
    }
    return rope;
}

void addLines(const core::OwnShip& ship, const OwnShipPose& pose, double bollardUp_m,
              std::vector<Rope>& ropes) {
    const ShipForm form = formOf(ship.vessel);
    for (std::size_t k = 0; k < std::min(ship.lines.size(), pose.lines.size()); ++k) {
        const core::LineLayout& layout = ship.lines[k];
        const core::LineState& line = pose.lines[k];
        const PlaceUp fairlead = pointOnShip(pose, layout.fairlead.x_m, layout.fairlead.y_m,
                                             form.deckAt_m(layout.fairlead.x_m) + kChock_m);
        if (line.onBollard())
            ropes.push_back(
                mooringLine(ship.vessel.mooring, line.length_m, fairlead, {layout.bollard, bollardUp_m}));
        else if (line.status == core::LineStatus::CastOff)  // its end in the water, being hauled in
            ropes.push_back(
                straightDown(fairlead, std::min(line.length_m, std::max(0.0, fairlead.up_m + kUnderWater_m)),
                             lineDiameter_m(ship.vessel.mooring), kRopePaint));
    }
}

void addCables(const core::OwnShip& ship, const OwnShipPose& pose, double water_m, std::vector<Rope>& ropes) {
    for (std::size_t k = 0; k < std::min(ship.anchorCount(), pose.anchors.size()); ++k) {
        const core::AnchorGear& gear = ship.vessel.groundTackle.anchors[k];
        const core::AnchorState& anchor = pose.anchors[k];
        const bool isOut = anchor.status != core::AnchorStatus::Home &&
                           anchor.status != core::AnchorStatus::CableParted && anchor.cableOut_m > 0.0;
        if (!isOut) continue;
        const PlaceUp hawse = pointOnShip(pose, gear.hawse.x_m, gear.hawse.y_m, gear.hawseHeight_m);
        ropes.push_back(anchorCable(gear, anchor, hawse, water_m));
    }
}

}  // namespace

std::vector<Rope> ropesOf(const core::World& world, const Moment& moment) {
    std::vector<Rope> ropes;
    // Heights are above the water as it stands now.
    const double bollardUp_m = world.area.meanTideLevel_m + kBollardHead_m - moment.tide_m;
    for (std::size_t i = 0; i < std::min(world.ships.size(), moment.ships.size()); ++i) {
        const OwnShipPose& pose = moment.ships[i];
        addLines(*world.ships[i], pose, bollardUp_m, ropes);
        addCables(*world.ships[i], pose, world.area.depth_m(pose.position) + moment.tide_m, ropes);
    }
    return ropes;
}

double sag_m(double span_m, double length_m, double weight_Npm, double stiffness_N) {
    const auto arcTooLong = [&](double sag) {
        const double pull_N = weight_Npm * span_m * span_m / (8.0 * sag);
        return span_m + 8.0 * sag * sag / (3.0 * span_m) > length_m * (1.0 + pull_N / stiffness_N);
    };
    double low = 1e-6, high = length_m + span_m;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (arcTooLong(middle) ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

std::vector<CablePoint> hangingCable(double horizontal_N, double atHawse_N, double weight_Npm,
                                     double depth_m) {
    constexpr int kPieces = 8;
    const double vertical_N = std::sqrt(std::max(0.0, atHawse_N * atHawse_N - horizontal_N * horizontal_N));
    const double a = horizontal_N / weight_Npm;
    if (a < 0.05) return {{0.0, 0.0}, {0.0, depth_m}};
    // From its lowest point the catenary rises a cosh(x / a) - a; the hawse is at sinh(x / a) = V / H.
    const double hawse = std::asinh(vertical_N / horizontal_N), top = a * std::cosh(hawse);
    std::vector<CablePoint> points;
    for (int i = 0; i <= kPieces; ++i) {
        const double down_m = depth_m * i / kPieces;
        // Where it is that far down; no farther than its lowest point.
        const double up = std::max(a, top - down_m);
        points.push_back({a * (hawse - std::acosh(up / a)), top - up});
    }
    return points;
}

}  // namespace sagara::render
