#pragma once

#include <optional>

#include "render/scene/Moment.h"
#include "ui/viewport/CameraRig.h"

namespace sagara::ui {

enum class DemoCameraKind : std::uint8_t { Bridge, Chase, Shore, Wing, Target };

/// A camera of the show. `index`: of the target, or of the place on shore.
struct DemoCamera {
    DemoCameraKind kind = DemoCameraKind::Bridge;
    std::size_t index = 0;
    bool port = false;  ///< of the wing
    friend bool operator==(const DemoCamera&, const DemoCamera&) = default;
};

/// The camera after this one that has something to show: no shore out of sight, no other ship far off. Bridge
/// and chase always have.
DemoCamera nextDemoCamera(const DemoCamera& now, const core::World& world, const render::Moment& moment);
/// Sets a viewport's rig up for it; again at every picture, for what it looks from may move.
void aim(CameraRig& rig, const DemoCamera& camera, const core::World& world, const render::Moment& moment);

/// The place of the area to look from, nearest to her and in sight; nothing when all are too far.
std::optional<std::size_t> shoreFor(const core::World& world, const render::Moment& moment);
/// The nearest other ship from which she can be seen.
std::optional<std::size_t> targetFor(const core::World& world, const render::Moment& moment);

}  // namespace sagara::ui
