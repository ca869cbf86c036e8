#include "app/import/AreaImport.h"

#include <cmath>

#include "app/import/AreaWriter.h"
#include "app/import/DepthModel.h"
#include "app/import/ElevationSource.h"
#include "app/import/ShelterModel.h"
#include "app/import/TextFile.h"
#include "core/base/Config.h"
#include "core/world/Area.h"

namespace sagara::importer {
namespace {

using core::NorthEast;
using core::config::formatNumber;
using core::config::Problems;

constexpr std::size_t kMostNodes = 5000;  ///< along one side of a grid; what the loader accepts

std::string oneDecimal(double value) { return formatNumber(std::round(value * 10.0) / 10.0); }

std::string joined(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return all.empty() ? "none" : all;
}

class Import {
public:
    Import(const ImportDescription& description, std::filesystem::path folder, Problems& problems)
        : m_description(description),
          m_frame(description.datum),
          m_folder(std::move(folder)),
          m_problems(problems) {}

    /// Problems of every source at once; only then do the models run.
    bool readSources() {
        const ImportDescription& d = m_description;
        m_content.coast = readCoast(d, m_folder, m_problems);
        m_content.tide = readTide(m_folder / d.tide.file, d.tide, m_problems);
        m_elevation = ElevationSource::read(m_folder / d.elevation.file, d.elevation.grid.box, m_problems);
        if (!d.placesFile.empty()) m_content.places = readPlaces(m_folder / d.placesFile, m_problems);
        if (!m_problems.empty()) return false;
        m_coast = localCoast(m_content.coast, d.box, m_frame);
        for (std::size_t i = 0; i < d.berths.size(); ++i) {
            checkFace(d.berths[i], m_coast, m_frame, "berths[" + std::to_string(i) + "]", m_problems);
        }
        m_depthRasters = rasters("depth.grids", d.depth.grids);
        m_shelterRasters = rasters("shelter.grids", d.shelter.grids);
        m_elevationRasters = rasters("elevation", {d.elevation.grid});
        return m_problems.empty();
    }

    ImportedArea run() {
        reportTide();
        makeDepths();
        makeShelter();
        makeElevation();
        for (const BerthRules& berth : m_description.berths)
            m_content.berths.push_back(planBerth(berth, m_frame));
        return {writeArea(m_description, m_content), std::move(m_report)};
    }

private:
    std::vector<Raster> rasters(const std::string& path, const std::vector<GridRules>& rules) {
        std::vector<Raster> all;
        for (const GridRules& wanted : rules) {
            const Raster r = rasterInside(wanted, m_frame);
            if (std::min(r.rows, r.columns) < 2 || std::max(r.rows, r.columns) > kMostNodes) {
                m_problems.add(
                    {path, "makes " + std::to_string(r.rows) + " by " + std::to_string(r.columns) + " nodes",
                     "2 to 5000 nodes along each side"});
            }
            all.push_back(r);
        }
        return all;
    }

    void reportTide() {
        m_report.push_back("tide: left out, not known to the simulator: " + joined(m_content.tide.unknown));
        m_report.push_back("tide: left out, below " + formatNumber(m_description.tide.leastAmplitude_m) +
                           " m: " + joined(m_content.tide.small));
    }

    void makeDepths() {
        const DepthRules& rules = m_description.depth;
        const DepthModel model(rules, m_coast, *m_elevation, m_description.elevation.landAtLeast_m, m_frame);
        for (const Raster& r : m_depthRasters)
            m_content.depths.push_back({r, rules.unit_m, model.depths_m(r)});
        for (const Sounding& s : rules.soundings) {
            const NorthEast p = m_frame.toLocal(s.at);
            m_report.push_back("depth: " + oneDecimal(s.depth_m) + " m reported, " +
                               oneDecimal(model.profile_m(p)) + " m by the profile, " +
                               oneDecimal(model.waterDepth_m(p)) + " m in the model: " + s.source);
        }
    }

    void makeShelter() {
        const std::vector<std::vector<double>> factors =
            modelShelter(m_description.shelter, m_shelterRasters, m_coast);
        for (std::size_t i = 0; i < factors.size(); ++i) {
            m_content.shelter.push_back({m_shelterRasters[i], m_description.shelter.unit, factors[i]});
        }
    }

    void makeElevation() {
        const Raster& raster = m_elevationRasters.front();
        std::vector<char> land = nodesInside(raster, m_coast.land);
        const std::vector<char> farther = nodesInside(raster, m_coast.context);
        std::vector<double> heights_m(raster.size(), 0.0);
        for (std::size_t i = 0; i < heights_m.size(); ++i) {
            if (!land[i] && !farther[i]) continue;
            const double height_m = m_elevation->height_m(m_frame.toGeo(raster.node(i)));
            heights_m[i] = std::max(m_description.elevation.landAtLeast_m, height_m);
        }
        m_content.elevation.push_back({raster, m_description.elevation.unit_m, std::move(heights_m)});
    }

    const ImportDescription& m_description;
    core::LocalFrame m_frame;
    std::filesystem::path m_folder;
    Problems& m_problems;
    AreaContent m_content;
    LocalCoast m_coast;
    std::optional<ElevationSource> m_elevation;
    std::vector<Raster> m_depthRasters, m_shelterRasters, m_elevationRasters;
    std::vector<std::string> m_report;
};

}  // namespace

core::Result<ImportedArea, Problems> importArea(const std::string& name, std::string_view description,
                                                const std::filesystem::path& folder) {
    const auto loaded = loadImportDescription(name, description);
    if (!loaded) return loaded.error();
    Problems problems(name);
    Import import(*loaded, folder, problems);
    if (!import.readSources()) return problems;
    ImportedArea made = import.run();
    // The loader has the last word: it also checks the members taken over from "area".
    const auto area = core::loadArea(name + " (the area made from it)", made.document);
    if (!area) return area.error();
    return made;
}

Problems importAreaFile(const std::filesystem::path& description, const std::filesystem::path& out,
                        std::vector<std::string>& report) {
    Problems problems;
    const auto text = readTextFile(description, problems);
    if (!text) return problems;
    const auto made = importArea(description.filename().string(), *text, description.parent_path());
    if (!made) return made.error();
    if (!writeWholeFile(out, made->document, problems)) return problems;
    report = made->report;
    report.push_back("written: " + out.string() + ", " + std::to_string(made->document.size()) + " bytes");
    return problems;
}

}  // namespace sagara::importer
