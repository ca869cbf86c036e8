#pragma once

#include <string>
#include <vector>

#include "app/import/BerthPlan.h"
#include "app/import/CoastSource.h"
#include "app/import/ImportDescription.h"
#include "app/import/PlaceSource.h"
#include "app/import/Raster.h"
#include "app/import/TideSource.h"

namespace sagara::importer {

/// One grid of the document: values in whole units.
struct GridContent {
    Raster raster;
    double unit = 1.0;
    std::vector<double> values;  ///< in the quantity's own measure, not yet rounded
};

/// Everything an area document is made of.
struct AreaContent {
    Coast coast;
    TideConstants tide;
    std::vector<GridContent> depths;
    std::vector<GridContent> shelter;
    std::vector<GridContent> elevation;
    std::vector<BerthPlan> berths;  ///< in the order of the description
    std::vector<SourcePlace> places;
};

/// The text of the area document: compact, one member or one item of a list per line, so that a difference
/// can be read. The same content gives the same bytes.
std::string writeArea(const ImportDescription& description, const AreaContent& content);

}  // namespace sagara::importer
