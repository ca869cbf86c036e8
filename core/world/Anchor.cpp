#include "core/world/Anchor.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/world/Catenary.h"

namespace sagara::core {
namespace {

constexpr double kFallSpeed_mps = 4.0;  // anchor and cable falling free through the water
constexpr double kRunSpeed_mps = 1.5;   // cable running out after the anchor, brake off
constexpr double kVeerSpeed_mps = 0.8;  // cable veered on the brake: its own weight runs it out
constexpr double kSubmerged =
    1.0 - kSeaWaterDensity_kgpm3 / 7850.0;  // weight of steel in water over that in air
constexpr double kCableFriction = 1.0;      // on sand and mud
constexpr double kDigIn_m = 4.0;            // dragged until the flukes hold fully
constexpr double kHoldUnset = 0.35;         // share of the holding power of an anchor that has not dug in
constexpr double kDragPace_mps = 2.0;       // speed of dragging at twice the holding power

/// Cable out in this tick, by what the windlass is doing.
double cableSpeed_mps(const AnchorGear& gear, const AnchorState& anchor) {
    switch (anchor.status) {
        case AnchorStatus::Running:
            return anchor.onBottom ? kRunSpeed_mps : kFallSpeed_mps;
        case AnchorStatus::Veering:
            return kVeerSpeed_mps;
        case AnchorStatus::Heaving:
            return -gear.heaveSpeed_mps;
        default:
            return 0.0;
    }
}

void workWindlass(const AnchorGear& gear, AnchorState& anchor, double dt_s) {
    const double speed_mps = cableSpeed_mps(gear, anchor);
    anchor.cableOut_m = std::clamp(anchor.cableOut_m + speed_mps * dt_s, 0.0, gear.cableLength_m);
    const bool ranOut = speed_mps > 0.0 && anchor.cableOut_m >= std::min(anchor.stopAt_m, gear.cableLength_m);
    const bool hoveIn = speed_mps < 0.0 && anchor.cableOut_m <= anchor.stopAt_m;
    if (ranOut || hoveIn) anchor.status = AnchorStatus::Held;
    if (hoveIn && anchor.cableOut_m == 0.0) anchor = {};
}

/// The anchor reaches the ground or leaves it.
void touchBottom(const AnchorGear& gear, AnchorState& anchor, double height_m, NorthEast hawse) {
    if (!anchor.onBottom && anchor.cableOut_m >= height_m) {
        anchor.onBottom = true;
        anchor.position = hawse;
        anchor.set = 0.0;
        anchor.dragged_m = 0.0;
    }
    // up and down: the windlass breaks it out
    const bool upAndDown = anchor.cableOut_m < height_m + 1.0 && distance(anchor.position, hawse) < height_m;
    const bool brokenOut = anchor.status == AnchorStatus::Heaving && upAndDown;
    if (brokenOut || anchor.cableOut_m < height_m) anchor.onBottom = false;
    if (!anchor.onBottom) {
        anchor.pull_N = 0.0;
        anchor.hawseTension_N =
            anchor.status == AnchorStatus::Home
                ? 0.0
                : cableWeight_Npm(gear) * anchor.cableOut_m + kSubmerged * gear.anchorMass_kg * kGravity_mps2;
    }
}

/// `slackening_m`: how far the anchor may move until the pull has fallen to the holding power.
void drag(AnchorState& anchor, double holding_N, double slackening_m, NorthEast hawse, double dt_s) {
    anchor.dragSpeed_mps = std::max(0.0, kDragPace_mps * (anchor.pull_N - holding_N) / holding_N);
    const double apart_m = distance(anchor.position, hawse);
    if (anchor.dragSpeed_mps == 0.0 || apart_m < 0.1) return;
    const double step_m = std::min({anchor.dragSpeed_mps * dt_s, slackening_m, apart_m});
    anchor.position = anchor.position + (step_m / apart_m) * (hawse - anchor.position);
    anchor.dragged_m += step_m;
    anchor.set = std::min(1.0, anchor.set + step_m / kDigIn_m);
}

}  // namespace

double cableWeight_Npm(const AnchorGear& gear) { return kSubmerged * gear.cableMass_kgpm * kGravity_mps2; }

/// EA of studlink cable from its mass: steel of reduced modulus on twice the bar's section.
double cableStiffness_N(const AnchorGear& gear) {
    constexpr double kModulus_Pa = 5.6e10;
    constexpr double kMassPerSection_kgpm3 =
        7850.0 * 3.55;  // mass per metre over the bar's section (ISO 1704)
    return kModulus_Pa * 2.0 * gear.cableMass_kgpm / kMassPerSection_kgpm3;
}

const char* anchorStatusName(AnchorStatus status) {
    switch (status) {
        case AnchorStatus::Home:
            return "home";
        case AnchorStatus::Running:
            return "running";
        case AnchorStatus::Held:
            return "held";
        case AnchorStatus::Veering:
            return "veering";
        case AnchorStatus::Heaving:
            return "heaving";
        case AnchorStatus::CableParted:
            return "cableParted";
    }
    return "";
}

double holdingPower_N(const AnchorGear& gear, const AnchorState& anchor, const AnchorGround& ground,
                      double lying_m, double uplift_rad) {
    const double weight_N = gear.anchorMass_kg * kGravity_mps2;
    const double dugIn = kHoldUnset + (1.0 - kHoldUnset) * anchor.set;
    const double flat = std::max(0.2, 1.0 - uplift_rad / (15.0 * kDegree_rad));
    const double slow = anchor.dragSpeed_mps > 0.5 ? 0.5 : 1.0;
    return gear.holdingFactor * weight_N * ground.holdingRatio * dugIn * flat * slow +
           kCableFriction * cableWeight_Npm(gear) * lying_m;
}

bool workAnchor(const AnchorGear& gear, AnchorState& anchor, const AnchorGround& ground, const ShipMotion& m,
                double dt_s) {
    if (anchor.status == AnchorStatus::Home || anchor.status == AnchorStatus::CableParted) return false;
    const NorthEast hawse = HeadingFrame(m.position(), m.heading_rad).point(gear.hawse);
    const double height_m = ground.depth_m + gear.hawseHeight_m;
    workWindlass(gear, anchor, dt_s);
    touchBottom(gear, anchor, height_m, hawse);
    if (!anchor.onBottom) return false;

    const double apart_m = distance(anchor.position, hawse);
    if (anchor.status == AnchorStatus::Running && apart_m > anchor.cableOut_m - height_m) {
        // brake off: the cable follows the ship with no more than its own weight in it
        anchor.cableOut_m = std::min(gear.cableLength_m, std::max(anchor.cableOut_m, apart_m + height_m));
    }
    const auto shapeAt = [&](double horizontal_m) {
        return cableShape(horizontal_m, height_m, anchor.cableOut_m, cableWeight_Npm(gear),
                          cableStiffness_N(gear));
    };
    const CableShape shape = shapeAt(apart_m);
    anchor.pull_N = shape.horizontal_N;
    anchor.hawseTension_N = shape.atHawse_N;
    if (shape.atHawse_N > gear.breakingLoad_N) {
        anchor = {};
        anchor.status = AnchorStatus::CableParted;
        return true;
    }
    const double holding_N = holdingPower_N(gear, anchor, ground, shape.lying_m, shape.uplift_rad);
    double slackening_m = 0.0;
    if (anchor.pull_N > holding_N) {
        constexpr double kProbe_m = 0.02;
        const double perMetre_N = (anchor.pull_N - shapeAt(apart_m - kProbe_m).horizontal_N) / kProbe_m;
        slackening_m = (anchor.pull_N - holding_N) / std::max(perMetre_N, 1.0);
    }
    drag(anchor, holding_N, slackening_m, hawse, dt_s);
    return false;
}

Load anchorLoad(const AnchorGear& gear, const AnchorState& anchor, const ShipMotion& m) {
    if (anchor.pull_N == 0.0) return {};
    const HeadingFrame frame(m.position(), m.heading_rad);
    const NorthEast lead = anchor.position - frame.point(gear.hawse);
    const double apart_m = length(lead);
    if (apart_m < 0.1) return {};
    return forceAt(gear.hawse, 0.0, frame.vectorInBody((anchor.pull_N / apart_m) * lead));
}

}  // namespace sagara::core
