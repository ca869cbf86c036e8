#include <algorithm>
#include <set>

#include "core/base/Config.h"
#include "core/base/Units.h"
#include "core/world/MarkDocument.h"

/// Reading of the area document. Positions are degrees in the file and frame N in the Area.
namespace sagara::core {
namespace {

class AreaReader {
public:
    explicit AreaReader(config::Reader& in) : m_in(in) {}

    Area read() {
        Area a;
        readIdentity(a);
        readTide(a);
        readStreamsOf(a);
        a.land = readRings("land");
        a.context = readRings("context");
        a.shore = Shore(readShore(), a.land);
        a.depths = readGrids("depths", {-500.0, 12000.0, "m"});
        a.shelter = readGrids("shelter", {0.0, 1.0, ""});
        a.elevation = readGrids("elevation", {-100.0, 9000.0, "m"});
        if (a.depths.empty() && m_in.has("depths")) m_in.problem("depths", "is empty", "at least one grid");
        for (const config::Node& node : m_in.listOr("berths")) a.berths.push_back(readBerth(node));
        for (const config::Node& node : m_in.listOr("marks")) a.marks.push_back(readMark(node));
        for (const config::Node& node : m_in.listOr("places")) a.places.push_back(readPlace(node));
        m_in.rejectUnknownKeys();
        return a;
    }

private:
    void readIdentity(Area& a) {
        m_in.text("document");
        m_in.integer("version", 1, kAreaDocumentVersion);
        a.id = m_in.id("id");
        a.name = m_in.text("name");
        a.notice = m_in.text("notice");
        a.attribution = m_in.texts("attribution");
        m_frame = a.frame = LocalFrame(m_in.geoPoint("datum"));
        a.timeZone = m_in.text("timeZone");
        a.utcOffset_min = m_in.integer("utcOffset_min", -720, 840);
        a.ialaRegion = m_in.choice<const char*>("ialaRegion", {{"A", "A"}, {"B", "B"}});
        a.depthDatum = m_in.text("depthDatum");
        a.depthSource = m_in.text("depthSource");
        a.waveDepth_m = m_in.number("waveDepth_m", {1.0, 12000.0, "m"});
        a.shoaling = m_in.flagOr("shoaling", false);
        a.holdingRatio = m_in.number("holdingRatio", {0.05, 2.0, ""});
    }

    void readTide(Area& a) {
        if (!m_in.has("tide")) return;
        config::Reader tide(m_in.child("tide"));
        tide.text("source");
        a.meanTideLevel_m = tide.number("meanAboveDatum_m", {0.0, 20.0, "m"});
        for (const config::Node& node : tide.list("constituents")) {
            config::Reader in(node);
            TidalConstituent c;
            c.name = in.text("name");
            if (!c.name.empty() && !isTidalConstituent(c.name)) {
                in.problem("name", "is \"" + c.name + "\"", "one of " + tidalConstituentNames());
            }
            c.amplitude_m = in.number("amplitude_m", {0.0, 10.0, "m"});
            c.phaseLag_rad = kDegree_rad * in.number("phaseLag_deg", {-360.0, 360.0, "deg"});
            in.rejectUnknownKeys();
            a.tide.push_back(c);
        }
        tide.rejectUnknownKeys();
    }

    void readStreamsOf(Area& a) {
        if (!m_in.has("streams")) return;
        config::Reader in(m_in.child("streams"));
        a.streams = readStreams(in, m_frame);
        if (a.streams.isTidal() && a.tide.empty())
            m_in.problem("tide", "is missing", "constituents: streams by the hour need a high water");
    }

    std::vector<NorthEast> local(const std::vector<GeoPoint>& points) const {
        std::vector<NorthEast> list;
        list.reserve(points.size());
        for (const GeoPoint& p : points) list.push_back(m_frame.toLocal(p));
        return list;
    }

    std::vector<std::vector<NorthEast>> readRings(const char* key) {
        std::vector<std::vector<NorthEast>> rings;
        for (const config::Node& node : m_in.listOr(key)) {
            config::Reader in(node);
            std::vector<NorthEast> ring = local(in.geoPoints("points", 3));
            in.rejectUnknownKeys();
            if (ring.size() >= 3 && clockwiseArea_m2(ring) < 0.0) std::reverse(ring.begin(), ring.end());
            rings.push_back(std::move(ring));
        }
        return rings;
    }

    std::vector<ShoreLine> readShore() {
        std::vector<ShoreLine> lines;
        for (const config::Node& node : m_in.listOr("shoreline")) {
            config::Reader in(node);
            ShoreLine line;
            line.kind = in.choice<ShoreKind>("kind", {{"quay", ShoreKind::Quay},
                                                      {"jetty", ShoreKind::Jetty},
                                                      {"breakwater", ShoreKind::Breakwater},
                                                      {"rock", ShoreKind::Rock},
                                                      {"beach", ShoreKind::Beach},
                                                      {"other", ShoreKind::Other}});
            line.name = in.textOr("name", "");
            line.points = local(in.geoPoints("points", 2));
            in.rejectUnknownKeys();
            lines.push_back(std::move(line));
        }
        return lines;
    }

    std::vector<Grid> readGrids(const char* key, config::Range range) {
        std::vector<Grid> grids;
        for (const config::Node& node : m_in.listOr(key)) {
            config::Reader in(node);
            config::Reader corner(in.child("southWest"));
            const config::Range place{-2e5, 2e5, "m"};
            const NorthEast southWest{corner.number("north_m", place), corner.number("east_m", place)};
            corner.rejectUnknownKeys();
            const double spacing_m = in.number("spacing_m", {0.5, 5000.0, "m"});
            const int rows = in.integer("rows", 2, 5000), columns = in.integer("columns", 2, 5000);
            const double unit = in.number("unit", {1e-4, 100.0, ""});
            const auto count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
            std::vector<float> values;
            values.reserve(count);
            for (const double v :
                 in.numbers("values", count, {range.low / unit, range.high / unit, "units"})) {
                values.push_back(static_cast<float>(v * unit));
            }
            in.rejectUnknownKeys();
            grids.emplace_back(southWest, spacing_m, static_cast<std::size_t>(rows),
                               static_cast<std::size_t>(columns), std::move(values));
        }
        return grids;
    }

    void checkUnique(config::Reader& in, const std::string& id) {
        if (!id.empty() && !m_ids.insert(id).second)
            in.problem("id", "is \"" + id + "\" again", "each id once");
    }

    Berth readBerth(const config::Node& node) {
        config::Reader in(node);
        Berth b;
        b.id = in.text("id");
        checkUnique(in, b.id);
        b.name = in.text("name");
        const std::vector<NorthEast> face = local(in.geoPoints("face", 2));
        if (face.size() > 2 || (face.size() == 2 && distance(face[0], face[1]) < 1.0)) {
            in.problem("face", "is not a straight line", "two points at least 1 m apart");
        }
        if (face.size() == 2) b.face = {face[0], face[1]};
        b.depth_m = in.number("depth_m", {0.5, 40.0, "m"});
        for (const config::Node& item : in.listOr("bollards")) {
            config::Reader bollard(item);
            const std::string id = bollard.text("id");
            checkUnique(bollard, id);
            b.bollards.push_back({id, m_frame.toLocal(bollard.geoPoint("at"))});
            bollard.rejectUnknownKeys();
        }
        for (const config::Node& item : in.listOr("fenders")) {
            config::Reader fender(item);
            Fender f;
            f.position = m_frame.toLocal(fender.geoPoint("at"));
            f.thickness_m = fender.number("thickness_m", {0.05, 5.0, "m"});
            f.width_m = fender.number("width_m", {0.1, 20.0, "m"});
            f.stiffness_Npm = 1000.0 * fender.number("stiffness_kNpm", {1.0, 1e5, "kN/m"});
            fender.rejectUnknownKeys();
            b.fenders.push_back(f);
        }
        in.rejectUnknownKeys();
        return b;
    }

    Mark readMark(const config::Node& node) {
        config::Reader in(node);
        Mark m = core::readMark(in, m_frame);
        checkUnique(in, m.id);
        return m;
    }

    Place readPlace(const config::Node& node) {
        config::Reader in(node);
        Place p{in.text("id"), in.text("name"), in.text("kind"), m_frame.toLocal(in.geoPoint("at"))};
        checkUnique(in, p.id);
        in.textOr("confidence", "");
        in.rejectUnknownKeys();
        return p;
    }

    config::Reader& m_in;
    LocalFrame m_frame{{}};
    std::set<std::string> m_ids;
};

}  // namespace

Result<Area, config::Problems> loadArea(const std::string& name, std::string_view text) {
    config::Document document(name, text);
    if (!document.isKind("area", kAreaDocumentVersion)) return document.problems();
    config::Reader in(document.root());
    Area area = AreaReader(in).read();
    return document.finish(std::move(area));
}

}  // namespace sagara::core
