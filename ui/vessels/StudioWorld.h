#pragma once

#include <memory>

#include "core/exercise/World.h"
#include "render/scene/Moment.h"

namespace sagara::ui {

/// A small world of deep open water with one vessel in it, to look at her.
std::shared_ptr<const core::World> studioWorld(const core::Vessel& vessel, bool night = false);
/// Lying stopped in a fair morning, a little sea.
render::Moment studioMoment(const core::World& world);

}  // namespace sagara::ui
