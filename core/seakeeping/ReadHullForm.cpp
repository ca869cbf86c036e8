#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/Config.h"
#include "core/seakeeping/CompleteHull.h"
#include "core/seakeeping/HullForm.h"

namespace sagara::core {
namespace {

using nlohmann::json;
constexpr double kNever = 1e12;

/// A null says that a value is not given: the same as no member at all.
std::string withoutNulls(std::string_view text) {
    json root = json::parse(text, nullptr, false);
    if (!root.is_object()) return std::string(text);
    for (auto it = root.begin(); it != root.end();) it = it->is_null() ? root.erase(it) : std::next(it);
    return root.dump();
}

std::optional<double> given(config::Reader& in, const char* key, config::Range range) {
    if (!in.has(key)) return std::nullopt;
    return in.number(key, range);
}

/// The part of a half breadth curve below the waterline, from the keel up.
std::vector<SectionPoint> halfSection(const std::vector<double>& heights_m, const std::vector<double>& row,
                                      double draught_m) {
    std::vector<SectionPoint> line;
    for (std::size_t i = 0; i < heights_m.size(); ++i) {
        const double y_m = row[i + 1], above_m = heights_m[i] - draught_m;
        if (above_m > 0.0) {
            if (!line.empty()) {
                const SectionPoint last = line.back();
                line.push_back({last.y_m + (y_m - last.y_m) * last.z_m / (last.z_m - above_m), 0.0});
            }
            break;
        }
        if (y_m <= 0.0 && !line.empty() && line.back().y_m <= 0.0) line.clear();
        if (line.empty() && y_m > 0.0) line.push_back({0.0, above_m});
        line.push_back({y_m, above_m});
        if (above_m == 0.0) break;
    }
    return line;
}

void readOffsets(config::Reader& in, HullForm& form) {
    const std::vector<double> heights_m = in.numbers("waterlines_m", 0, {-50.0, 50.0, "m"});
    if (heights_m.empty() || heights_m.back() < form.draught_m)
        in.problem("waterlines_m", "end below the waterline", "heights that reach draught_m");
    for (const config::Node& node : in.list("offsets")) {
        const std::vector<double> row = node.numbers(heights_m.size() + 1, {-1000.0, 1000.0, "m"});
        if (row.empty()) continue;
        const std::vector<SectionPoint> line = halfSection(heights_m, row, form.draught_m);
        if (line.size() < 2) continue;
        const SectionArea area = areaOf(panelsOf(line));
        form.stations.push_back(
            {row[0], 2.0 * line.back().y_m, -line.front().z_m, area.area_m2, form.draught_m - area.depth_m});
        form.offsets.push_back(line);
    }
}

void readRows(config::Reader& in, HullForm& form) {
    for (const config::Node& node : in.list("stations")) {
        const std::vector<double> row = node.numbers(5, {-kNever, kNever, "m or m2"});
        if (row.empty()) continue;
        form.stations.push_back({row[0], row[1], row[2], row[3], row[4]});
        if (row[1] < 0.0 || row[2] < 0.0 || row[3] < 0.0)
            node.problem("has a breadth, draught or area below nothing", "0 or more");
    }
}

void checkStations(config::Reader& in, const HullForm& form) {
    if (form.stations.size() < 5)
        in.problem("stations", "are " + std::to_string(form.stations.size()), "5 or more, or Cb and Cw");
    for (std::size_t i = 1; i < form.stations.size(); ++i) {
        if (form.stations[i].x_m <= form.stations[i - 1].x_m)
            in.problem("stations", "go back at row " + std::to_string(i), "rows from aft forward");
    }
}

std::optional<FormCoefficients> readCoefficients(config::Reader& in, const HullForm& form,
                                                 GivenOfHull& known) {
    std::optional<double> block = given(in, "Cb", {0.2, 1.0, ""});
    if (!block && known.volume_m3)
        block = *known.volume_m3 / (form.lengthBp_m * form.breadth_m * form.draught_m);
    const std::optional<double> midship = given(in, "Cm", {0.3, 1.0, ""});
    const std::optional<double> waterplane = given(in, "Cw", {0.3, 1.0, ""});
    if (!block) return std::nullopt;
    // Waterplane of usual ships: Schneekluth and Bertram (1998), Ship Design, 1.6.
    return FormCoefficients{*block, midship.value_or(usualMidshipCoefficient(*block)),
                            waterplane.value_or((1.0 + 2.0 * *block) / 3.0)};
}

}  // namespace

Result<HullForm, config::Problems> readHullForm(const std::string& name, std::string_view text) {
    config::Document document(name, withoutNulls(text));
    config::Reader in(document.root());
    HullForm form;
    form.name = in.textOr("name", name);
    form.lengthBp_m = in.number("length_pp_m", {0.1, 1000.0, "m"});
    form.breadth_m = in.number("breadth_m", {0.01, 200.0, "m"});
    form.draught_m = in.number("draught_m", {0.005, 60.0, "m"});
    form.waterDensity_kgpm3 = in.numberOr("rho_kgpm3", 0.0, {900.0, 1100.0, "kg/m3"});
    form.mass_kg = in.numberOr("mass_kg", 0.0, {1e-3, kNever, "kg"});
    form.rollGyradius_m = in.numberOr("kxx_m", 0.0, {1e-3, 200.0, "m"});
    form.pitchGyradius_m = in.numberOr("kyy_m", 0.0, {1e-3, 500.0, "m"});
    form.yawGyradius_m = in.numberOr("kzz_m", 0.0, {1e-3, 500.0, "m"});
    form.addedRollDamping_Nms = in.numberOr("roll_damping_added_Nms", 0.0, {0.0, 1e15, "N m s"});
    form.bilgeKeelLength_m = in.numberOr("bilge_keel_length_m", 0.0, {0.0, 500.0, "m"});
    form.bilgeKeelBreadth_m = in.numberOr("bilge_keel_breadth_m", 0.0, {0.0, 5.0, "m"});
    GivenOfHull known{.volume_m3 = given(in, "volume_m3", {1e-4, kNever, "m3"}),
                      .freeboard_m = given(in, "freeboard_m", {0.0, 100.0, "m"}),
                      .gravityForward_m = given(in, "xg_m", {-500.0, 500.0, "m"}),
                      .gravityHeight_m = given(in, "zg_m", {-50.0, 200.0, "m"}),
                      .metacentricHeight_m = given(in, "gm_transverse_m", {-50.0, 200.0, "m"}),
                      .form = std::nullopt};
    known.form = readCoefficients(in, form, known);
    if (in.has("stations")) {
        readRows(in, form);
    } else if (in.has("offsets")) {
        readOffsets(in, form);
    }
    if (!form.stations.empty() || !known.form) checkStations(in, form);
    if (in.sound()) complete(form, known);
    return document.finish(form);
}

}  // namespace sagara::core
