#pragma once

#include "core/assess/Criterion.h"

namespace sagara::core {

/// "contact-speed": touching a quay's fenders, a quay or a breakwater faster than "limit_mps". Each blow
/// counts.
std::unique_ptr<const Criterion> makeContactSpeedCriterion(Criterion::Terms terms, config::Reader& in,
                                                           const MissionContext& context);
/// "contact-energy": a blow of more than "limit_kJ" on fenders, quay, breakwater or shore.
std::unique_ptr<const Criterion> makeContactEnergyCriterion(Criterion::Terms terms, config::Reader& in,
                                                            const MissionContext& context);
/// "collision": touching another ship at all.
std::unique_ptr<const Criterion> makeCollisionCriterion(Criterion::Terms terms, config::Reader& in,
                                                        const MissionContext& context);
/// "grounding": touching the ground at all.
std::unique_ptr<const Criterion> makeGroundingCriterion(Criterion::Terms terms, config::Reader& in,
                                                        const MissionContext& context);
/// "parted": a line or a cable parts.
std::unique_ptr<const Criterion> makePartedCriterion(Criterion::Terms terms, config::Reader& in,
                                                     const MissionContext& context);

}  // namespace sagara::core
