#pragma once

#include "core/assess/Criterion.h"

namespace sagara::core {

/// "anchor-place": anchor let go farther than "limit_m" from the place "at". The anchor counts, not the ship.
std::unique_ptr<const Criterion> makeAnchorPlaceCriterion(Criterion::Terms terms, config::Reader& in,
                                                          const MissionContext& context);
/// "let-go-speed": sternway over ground at let go outside "least_kn" to "most_kn". Headway is negative
/// sternway.
std::unique_ptr<const Criterion> makeLetGoSpeedCriterion(Criterion::Terms terms, config::Reader& in,
                                                         const MissionContext& context);
/// "anchor-drag": anchor moved more than "limit_m" over the ground since it was let go. Breaks once an
/// anchor.
std::unique_ptr<const Criterion> makeAnchorDragCriterion(Criterion::Terms terms, config::Reader& in,
                                                         const MissionContext& context);

}  // namespace sagara::core
