#pragma once

#include <QString>
#include <string>

#include "core/world/Area.h"

/// What an area's things are called on a chart.
namespace sagara::ui {

/// The name less what is in brackets: the chart is too small for it.
QString plainName(const std::string& name);

/// "Fl(2) W 15s"
QString lightCharacter(const core::Light& light);
/// "Fl(2) W 15s 28m 18M": character, height above the water, range.
QString lightText(const core::Light& light);

enum class LightColour { White, Red, Green };
/// By the letter in its character; white when there is none.
LightColour lightColour(const core::Light& light);

/// Whether its depths are of a model, not of a survey.
bool depthsAreModelled(const core::Area& area);

}  // namespace sagara::ui
