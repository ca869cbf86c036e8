#include "app/tools/HullChoice.h"

#include "app/files/Files.h"

namespace sagara::tools {

core::Result<core::HullForm, std::string> readHullFile(const std::string& file) {
    const auto text = files::readTextFile(file);
    if (!text) return text.error().message;
    auto form = core::readHullForm(file, *text);
    if (!form) return form.error().text();
    return std::move(form).value();
}

core::Result<core::HullForm, std::string> openHull(const run::Store& store, const HullChoice& choice) {
    if (!choice.file.empty()) return readHullFile(choice.file);
    const auto vessel = openVessel(store, choice.ship);
    if (!vessel) return vessel.error();
    core::HullForm form = core::hullFormOf(vessel->hull);
    form.name = choice.ship.vessel;
    return form;
}

}  // namespace sagara::tools
