#include "ui/widgets/ShipShape.h"

namespace sagara::ui {

std::array<core::NorthEast, 9> shipOutline(core::NorthEast midship, double heading_rad, double length_m,
                                           double beam_m) {
    const core::HeadingFrame ship(midship, heading_rad);
    constexpr std::array<std::array<double, 2>, 9> kShape{{{0.5, 0.0},
                                                           {0.36, 0.32},
                                                           {0.2, 0.5},
                                                           {-0.38, 0.5},
                                                           {-0.5, 0.425},
                                                           {-0.5, -0.425},
                                                           {-0.38, -0.5},
                                                           {0.2, -0.5},
                                                           {0.36, -0.32}}};
    std::array<core::NorthEast, 9> outline;
    for (std::size_t i = 0; i < kShape.size(); ++i)
        outline[i] = ship.point({kShape[i][0] * length_m, kShape[i][1] * beam_m});
    return outline;
}

}  // namespace sagara::ui
