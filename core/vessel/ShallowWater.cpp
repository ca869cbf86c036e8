#include "core/vessel/ShallowWater.h"

namespace sagara::core {

ShallowWater readShallowWater(config::Reader& in) {
    ShallowWater s;
    s.squat = in.choice<SquatFormula>("squat", {{"barrass-simple", SquatFormula::BarrassSimple},
                                                {"barrass", SquatFormula::Barrass},
                                                {"icorels", SquatFormula::Icorels},
                                                {"yoshimura", SquatFormula::Yoshimura}});
    s.hull = in.choice<bool>("hull", {{"kijima", true}, {"none", false}});
    s.bank = in.choice<bool>("bank", {{"norrbin", true}, {"none", false}});
    s.ships = in.choice<bool>("ships", {{"slender-body", true}, {"none", false}});
    s.provenance = readProvenance(in);
    in.rejectUnknownKeys();
    return s;
}

}  // namespace sagara::core
