#include "app/tools/VesselChoice.h"

#include "app/files/FindDocument.h"

namespace sagara::tools {

core::Result<core::Vessel, std::string> openVessel(const core::DocumentSource& source,
                                                   const VesselChoice& choice) {
    const auto document = files::findDocument(source, core::DocumentKind::Vessel, choice.vessel);
    if (!document) return document.error();
    auto vessel = core::loadVessel(document->name, document->text);
    if (!vessel) return vessel.error().text();
    if (const auto model = vessel->model(choice.model); !model) return model.error();
    return std::move(vessel).value();
}

}  // namespace sagara::tools
