#pragma once

/// Properties by which a table and whoever keeps its looks from one start to the next understand each other.
namespace sagara::ui::kept {

inline constexpr const char* kWidthsChosen = "widthsChosen";  ///< by a person: the table fits them no more
inline constexpr const char* kFitting = "fittingColumns";     ///< the table is at it itself

}  // namespace sagara::ui::kept
