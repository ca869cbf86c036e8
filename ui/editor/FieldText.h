#pragma once

#include <optional>

#include "core/base/LocalFrame.h"
#include "ui/editor/FieldSpec.h"

/// What stands in a field's line, and what is made of what is typed there.
namespace sagara::ui::editor {

QString shown(const Field& field, const Json* value);
/// Nothing when it is no value of this kind. Limits are the loader's.
std::optional<Json> typed(const Field& field, const QString& text);
/// "0 to 120 kn"; empty when anything goes.
QString accepted(const Field& field);

QString positionText(core::GeoPoint place);
/// "006°01.95'N 080°13.60'E", "6 1.95 N 80 13.6 E", or decimal degrees "6.0325, 80.2267".
std::optional<core::GeoPoint> typedPosition(const QString& text);
Json positionJson(core::GeoPoint place);
std::optional<core::GeoPoint> positionOf(const Json* value);

/// A row of a list in a few words.
QString rowInWords(const ListSpec& spec, const Json& row);

}  // namespace sagara::ui::editor
