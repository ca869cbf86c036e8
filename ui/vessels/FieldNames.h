#pragma once

#include <QString>
#include <string>

namespace sagara::ui {

/// How a key of a document reads: "lengthBp_m" is "Length between perpendiculars" in "m".
struct FieldName {
    QString label;
    QString unit;
};
FieldName fieldName(const std::string& key);

}  // namespace sagara::ui
