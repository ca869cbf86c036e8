#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/import/ImportDescription.h"
#include "app/import/Raster.h"
#include "core/world/Shore.h"

namespace sagara::importer {

using GeoRing = std::vector<core::GeoPoint>;  ///< closed, first point not repeated

struct CoastLine {
    core::ShoreKind kind = core::ShoreKind::Other;
    std::string name;  ///< empty when the source has none
    std::vector<core::GeoPoint> points;
};

/// Land and shoreline as the sources give them.
struct Coast {
    std::vector<GeoRing> land;     ///< fills the box in detail
    std::vector<GeoRing> context;  ///< coarser, beyond the box
    std::vector<CoastLine> lines;
};

/// Problems of all three files at once. Every category must be named in the description.
Coast readCoast(const ImportDescription& description, const std::filesystem::path& folder,
                core::config::Problems& problems);

/// The same in frame N, with what the models ask of it.
struct LocalCoast {
    std::vector<Ring> land;
    std::vector<Ring> context;
    core::Shore shore;    ///< everything in the box
    core::Shore natural;  ///< beach, rock and other, in the box and on the context rings beyond it: the sea
                          ///< bed falls off from there
};
LocalCoast localCoast(const Coast& coast, const GeoBox& box, const core::LocalFrame& frame);

/// Built by people: quay, jetty or breakwater. The sea bed does not rise towards it.
bool isWorks(core::ShoreKind kind);

}  // namespace sagara::importer
