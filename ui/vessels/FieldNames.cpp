#include "ui/vessels/FieldNames.h"

#include <QCoreApplication>
#include <array>
#include <cctype>
#include <utility>

namespace sagara::ui {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("sagara::ui::FieldNames", text); }

constexpr std::array<std::pair<const char*, const char*>, 27> kUnits{
    {{"perDeg", "1/°"}, {"kgpm3", "kg/m³"}, {"kgpm", "kg/m"}, {"kgm2", "kg m²"}, {"rpmps", "rpm/s"},
     {"degps", "°/s"},  {"radps", "rad/s"}, {"perS", "1/s"},  {"rpm", "rpm"},    {"rps", "1/s"},
     {"mps", "m/s"},    {"deg", "°"},       {"kNpm", "kN/m"}, {"kN", "kN"},      {"kW", "kW"},
     {"kg", "kg"},      {"m3", "m³"},       {"m2", "m²"},     {"kn", "kn"},      {"shackles", "shackles"},
     {"N", "N"},        {"M", "M"},         {"s", "s"},       {"m", "m"},        {"Hz", "Hz"},
     {"K", "K"},        {"W", "W"}}};

const std::array<std::pair<const char*, const char*>, 25> kLabels{
    {{"x", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Forward of midship")},
     {"y", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "To starboard")},
     {"id", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Id")},
     {"document", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Kind of document")},
     {"lengthBp", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Length between perpendiculars")},
     {"lengthOverall", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Length overall")},
     {"depth", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Depth, keel to main deck")},
     {"metacentricHeight", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Metacentric height GM")},
     {"rgb", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Red, green, blue")},
     {"of", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Product of")},
     {"X", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "X, surge")},
     {"Y", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Y, sway")},
     {"K", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "K, roll")},
     {"N", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "N, yaw")},
     {"xG", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Centre of gravity, forward of midship")},
     {"zG", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Centre of gravity, below the waterline")},
     {"Ixx", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Roll inertia Ixx")},
     {"Izz", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Yaw inertia Izz")},
     {"model", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Ship model")},
     {"models", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Ship models")},
     {"picture", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "3D model")},
     {"bridgeEye", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Eye point on the bridge")},
     {"areaEach", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Area of each")},
     {"blendermannType", QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Type after Blendermann")},
     {"thrustCoefficients",
      QT_TRANSLATE_NOOP("sagara::ui::FieldNames", "Thrust coefficients KT = c0 + c1 J + c2 J²")}}};

/// "rudderYawLever" as "Rudder yaw lever".
QString spaced(const std::string& name) {
    QString text;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto c = static_cast<unsigned char>(name[i]);
        const bool starts = i > 0 && std::isupper(c) && std::islower(static_cast<unsigned char>(name[i - 1]));
        if (starts) text += QLatin1Char(' ');
        text += QLatin1Char(static_cast<char>(i == 0 ? std::toupper(c) : starts ? std::tolower(c) : c));
    }
    return text;
}

}  // namespace

FieldName fieldName(const std::string& key) {
    FieldName name;
    std::string stem = key;
    if (const auto cut = key.rfind('_'); cut != std::string::npos) {
        for (const auto& [suffix, unit] : kUnits) {
            if (key.substr(cut + 1) != suffix) continue;
            name.unit = QString::fromUtf8(unit);
            stem = key.substr(0, cut);
            break;
        }
    }
    for (const auto& [known, label] : kLabels)
        if (stem == known) name.label = tr(label);
    if (name.label.isEmpty()) name.label = spaced(stem);
    return name;
}

}  // namespace sagara::ui
