#pragma once

#include <optional>
#include <string_view>

namespace sagara::render {

/// How much a machine is asked to draw. Medium is meant for two cores without a graphics card.
enum class Preset { Low, Medium, High };

std::optional<Preset> presetOf(std::string_view name);  ///< "low", "medium", "high"

/// What a preset means, in one place.
struct PresetFigures {
    int seaRings;             ///< of the sea's polar grid
    int seaColumnsPerSector;  ///< of 24 sectors
    bool shortWaves;          ///< the 25 m tile in the picture's slopes
    bool foam;
    bool mipmapsBetween;  ///< of the slopes of waves
    bool clouds;
    int palms;
    int houses;
    double detailWithin_m;  ///< rails and rigging of ships nearer than this, in a picture 720 pixels high
};
PresetFigures figuresOf(Preset preset);

}  // namespace sagara::render
