#include "render/scene/ship/ShipForm.h"

#include <algorithm>
#include <cmath>

namespace sagara::render {
namespace {

ShipStyle styleOf(const std::string& type) {
    const auto has = [&](const char* word) { return type.find(word) != std::string::npos; };
    if (has("tanker")) return ShipStyle::Tanker;
    if (has("container")) return ShipStyle::Container;
    if (has("ferry")) return ShipStyle::Ferry;
    if (has("motor yacht")) return ShipStyle::FastCraft;  // no sails
    if (has("yacht")) return ShipStyle::Yacht;
    if (has("tug")) return ShipStyle::Tug;
    if (has("fish")) return ShipStyle::Fishing;
    if (has("fast")) return ShipStyle::FastCraft;
    if (has("patrol") || has("navy") || has("frigate") || has("corvette")) return ShipStyle::Patrol;
    return ShipStyle::Coaster;
}

ShipStyle styleOf(core::TargetType type) {
    switch (type) {
        case core::TargetType::Fishing:
            return ShipStyle::Fishing;
        case core::TargetType::Coaster:
            return ShipStyle::Coaster;
        case core::TargetType::Tanker:
            return ShipStyle::Tanker;
        case core::TargetType::Container:
            return ShipStyle::Container;
        case core::TargetType::Ferry:
            return ShipStyle::Ferry;
        case core::TargetType::Yacht:
            return ShipStyle::Yacht;
        case core::TargetType::Tug:
            return ShipStyle::Tug;
        case core::TargetType::FastCraft:
            return ShipStyle::FastCraft;
    }
    return ShipStyle::Coaster;
}

/// Freeboard as a share of the draught and block coefficient usual for the type; bridge front as a share of
/// the length from midship, its eyes' height as a share of the length.
struct Usual {
    double freeboard, block, bridge, bridgeHeight;
};
Usual usualOf(ShipStyle style) {
    switch (style) {
        case ShipStyle::Patrol:
            return {1.2, 0.45, 0.15, 0.15};
        case ShipStyle::Fishing:
            return {0.8, 0.55, -0.10, 0.30};
        case ShipStyle::Coaster:
            return {0.55, 0.75, -0.30, 0.16};
        case ShipStyle::Tanker:
            return {0.45, 0.82, -0.34, 0.15};
        case ShipStyle::Container:
            return {0.85, 0.68, -0.26, 0.16};
        case ShipStyle::Ferry:
            return {0.9, 0.60, 0.30, 0.16};
        case ShipStyle::Yacht:
            return {0.55, 0.40, 0.02, 0.18};
        case ShipStyle::Tug:
            return {0.5, 0.58, 0.10, 0.32};
        case ShipStyle::FastCraft:
            return {1.3, 0.42, -0.05, 0.22};
    }
    return {};
}

}  // namespace

double ShipForm::deckAt_m(double x_m) const {
    const double s = std::clamp(x_m / (0.5 * length_m), -1.0, 1.0);
    const double bow = style == ShipStyle::Fishing || style == ShipStyle::Patrol ? 0.032 : 0.018;
    return freeboard_m + length_m * (s > 0.0 ? bow * s * s : 0.006 * s * s);
}

ShipForm formOf(const core::Vessel& v) {
    ShipForm f;
    f.style = styleOf(v.type);
    f.length_m = v.hull.lengthOverall_m;
    f.beam_m = v.hull.beam_m;
    f.draught_m = v.hull.draught_m;
    f.freeboard_m = std::max(0.5, v.hull.depth_m - v.hull.draught_m);
    f.block = v.hull.blockCoefficient();
    f.bridge_m = v.bridgeEye.x_m;
    f.bridgeHeight_m = v.bridgeEyeHeight_m;
    f.stations = v.hull.stations;
    return f;
}

ShipForm formOf(const core::TargetLayout& t) {
    ShipForm f;
    f.style = styleOf(t.type);
    const Usual usual = usualOf(f.style);
    f.length_m = t.length_m;
    f.beam_m = t.beam_m;
    f.draught_m = t.draught_m;
    f.freeboard_m = std::max(0.4, usual.freeboard * t.draught_m);
    f.block = usual.block;
    f.bridge_m = usual.bridge * t.length_m;
    f.bridgeHeight_m = std::max(f.freeboard_m + 2.2, usual.bridgeHeight * t.length_m);
    return f;
}

}  // namespace sagara::render
