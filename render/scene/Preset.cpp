#include "render/scene/Preset.h"

namespace sagara::render {

std::optional<Preset> presetOf(std::string_view name) {
    if (name == "low") return Preset::Low;
    if (name == "medium") return Preset::Medium;
    if (name == "high") return Preset::High;
    return std::nullopt;
}

PresetFigures figuresOf(Preset preset) {
    switch (preset) {
        case Preset::Low:
            return {52, 12, true, false, false, false, 60, 250, 400.0};
        case Preset::Medium:
            return {76, 18, true, true, false, true, 150, 500, 700.0};
        case Preset::High:
            return {120, 36, true, true, true, true, 500, 1200, 3000.0};
    }
    return {};
}

}  // namespace sagara::render
