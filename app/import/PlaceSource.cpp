#include "app/import/PlaceSource.h"

#include "app/import/GeoLayer.h"

namespace sagara::importer {

std::vector<SourcePlace> readPlaces(const std::filesystem::path& file, core::config::Problems& all) {
    core::config::Problems problems(file.filename().string());
    std::vector<SourcePlace> places;
    for (const GeoFeature& feature : readGeoLayer(file, GeoShape::Point, all)) {
        for (const char* key : {"id", "name", "class"}) {
            if (feature.property(key).empty())
                problems.add({feature.path + "." + key, "is missing", "a text"});
        }
        places.push_back({feature.property("id"), feature.property("name"), feature.property("class"),
                          feature.property("confidence"), feature.parts[0][0]});
    }
    if (!problems.empty()) all.append(problems);
    return places;
}

}  // namespace sagara::importer
