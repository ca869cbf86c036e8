#include "app/tools/HullChoice.h"

#include "app/files/Files.h"

namespace sagara::tools {

core::Result<core::HullForm, std::string> openHull(const run::Store& store, const HullChoice& choice) {
    if (choice.file.empty()) {
        const auto vessel = openVessel(store, choice.ship);
        if (!vessel) return vessel.error();
        core::HullForm form = core::hullFormOf(vessel->hull);
        form.name = choice.ship.vessel;
        return form;
    }
    const auto text = files::readTextFile(choice.file);
    if (!text) return text.error().message;
    auto form = core::readHullForm(choice.file, *text);
    if (!form) return form.error().text();
    return std::move(form).value();
}

}  // namespace sagara::tools
