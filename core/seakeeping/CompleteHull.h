#pragma once

#include "core/seakeeping/HullForm.h"

namespace sagara::core {

/// What a description of a hull may say beside the members of `HullForm`.
struct GivenOfHull {
    std::optional<double> volume_m3;
    std::optional<double> freeboard_m;
    std::optional<double> gravityForward_m;
    std::optional<double> gravityHeight_m;
    std::optional<double> metacentricHeight_m;
    std::optional<FormCoefficients> form;
};

/// Fills what is still nothing in `form` by estimates, each with a note: stations from the coefficients,
/// density of sea water, mass that floats at the draught, centre of gravity over the centre of buoyancy and
/// at the height of the metacentric height (or of usual ships), gyradii of 0.37 B and 0.25 Lpp, freeboard of
/// half the draught.
void complete(HullForm& form, const GivenOfHull& given);

}  // namespace sagara::core
