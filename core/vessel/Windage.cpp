#include "core/vessel/Windage.h"

#include <array>

namespace sagara::core {
namespace {

// As tabulated in Fossen (2021), table 10.3; drilling vessel: means of the printed ranges.
constexpr std::array<BlendermannType, 17> kTypes{{
    {"car carrier", 0.95, 0.55, 0.60, 0.80, 1.2},
    {"cargo vessel loaded", 0.85, 0.65, 0.55, 0.40, 1.7},
    {"cargo vessel with deck containers", 0.85, 0.55, 0.50, 0.40, 1.4},
    {"container ship loaded", 0.90, 0.55, 0.55, 0.40, 1.4},
    {"destroyer", 0.85, 0.60, 0.65, 0.65, 1.1},
    {"diving support vessel", 0.90, 0.60, 0.80, 0.55, 1.7},
    {"drilling vessel", 1.00, 0.85, 0.925, 0.10, 1.7},
    {"ferry", 0.90, 0.45, 0.50, 0.80, 1.1},
    {"fishing vessel", 0.95, 0.70, 0.70, 0.40, 1.1},
    {"LNG tanker", 0.70, 0.60, 0.65, 0.50, 1.1},
    {"offshore supply vessel", 0.90, 0.55, 0.80, 0.55, 1.2},
    {"passenger liner", 0.90, 0.40, 0.40, 0.80, 1.2},
    {"research vessel", 0.85, 0.55, 0.65, 0.60, 1.4},
    {"speed boat", 0.90, 0.55, 0.60, 0.60, 1.1},
    {"tanker loaded", 0.70, 0.90, 0.55, 0.40, 3.1},
    {"tanker ballast", 0.70, 0.75, 0.55, 0.40, 2.2},
    {"tender", 0.85, 0.55, 0.55, 0.65, 1.1},
}};

void readBlendermann(config::Reader& in, Windage& w) {
    const std::string name = in.text("blendermannType");
    if (const BlendermannType* type = findBlendermannType(name)) {
        w.type = *type;
    } else if (!name.empty()) {
        std::string names;
        for (const BlendermannType& row : kTypes)
            names += (names.empty() ? "" : ", ") + std::string(row.name);
        in.problem("blendermannType", "is \"" + name + "\"", "one of " + names);
    }
}

IsherwoodParticulars readIsherwood(config::Reader& in) {
    IsherwoodParticulars p;
    p.perimeter_m = in.number("perimeter_m", {1.0, 3000.0, "m"});
    p.superstructureLateralArea_m2 = in.number("superstructureLateralArea_m2", {0.0, 20000.0, "m2"});
    p.mastGroups = in.integer("mastGroups", 0, 12);
    return p;
}

}  // namespace

const BlendermannType* findBlendermannType(std::string_view name) {
    for (const BlendermannType& type : kTypes) {
        if (type.name == name) return &type;
    }
    return nullptr;
}

Windage readWindage(config::Reader& in) {
    Windage w;
    if (in.has("method") &&
        in.choice<bool>("method", {{"blendermann1994", false}, {"isherwood1972", true}})) {
        w.isherwood = readIsherwood(in);
    } else {
        readBlendermann(in, w);
    }
    w.frontalArea_m2 = in.number("frontalArea_m2", {0.5, 5000.0, "m2"});
    w.lateralArea_m2 = in.number("lateralArea_m2", {1.0, 20000.0, "m2"});
    w.centroidForward_m = in.number("centroidForward_m", {-150.0, 150.0, "m"});
    w.centroidHeight_m = in.number("centroidHeight_m", {0.0, 60.0, "m"});
    w.provenance = readProvenance(in);
    in.rejectUnknownKeys();
    return w;
}

}  // namespace sagara::core
