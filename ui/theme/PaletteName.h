#pragma once

namespace sagara::ui {

/// By the light on a bridge, as on ECDIS.
enum class PaletteName { Day, Dusk, Night };

}  // namespace sagara::ui
