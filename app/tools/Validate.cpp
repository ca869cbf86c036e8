#include "app/tools/Validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/files/AssetSource.h"
#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "app/tools/Validation.h"
#include "core/exercise/BuildId.h"
#include "ui/report/ValidationReport.h"

namespace sagara::tools {
namespace {

/// Four digits, no powers of ten.
std::string shown(double value) {
    if (!std::isfinite(value)) return "not reached";
    const double size = std::abs(value);
    if (size > 0.0 && size < 1e-4) return "< 0.0001";
    return size >= 1e3 ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value);
}
std::string shown(double value, bool share) {
    if (!std::isfinite(value)) return "";
    const double printed = share ? 100.0 * value : value, size = std::abs(printed);
    const std::string number = size > 0.0 && size < 1e-3 ? "< 0.001" : fmt::format("{:.3g}", printed);
    return share ? number + " %" : number;
}

std::string toleranceOf(const ValidationRow& row) {
    if (row.atMost) return "at most";
    return row.share ? fmt::format("{:.3g} %", 100.0 * row.tolerance) : fmt::format("{:.3g}", row.tolerance);
}

/// Names of measures as people write them.
std::string spaced(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    for (const auto& [plain, raised] : {std::pair(", m2", ", m²"), std::pair(", m3", ", m³")})
        if (name.ends_with(plain)) name.replace(name.size() - 4, 4, raised);
    return name;
}

std::string csvRow(const ValidationResult& r, const ValidationRow& row) {
    return fmt::format("{},{},{},{:.6g},{:.6g},{:.4g},{:.4g},{}\n", r.id, r.evidence,
                       row.quantity.find(',') == std::string::npos ? row.quantity : '"' + row.quantity + '"',
                       row.measured, row.reference, row.error(), row.tolerance, row.ok() ? "ok" : "short");
}

void addTo(report::ValidationData& data, const ValidationResult& r) {
    for (const ValidationRow& row : r.outcome.rows) {
        data.rows.push_back({r.title, r.evidence, spaced(row.quantity), shown(row.measured),
                             shown(row.reference), shown(row.error(), row.share), toleranceOf(row),
                             row.ok()});
    }
    if (!r.outcome.trouble.empty())
        data.rows.push_back({r.title, r.evidence, r.outcome.trouble, "", "", "", "", false});
    for (report::XyPlot plot : r.outcome.plots) {
        if (plot.title.empty()) plot.title = r.title;
        plot.note = spaced(plot.note);
        data.plots.push_back(std::move(plot));
    }
    for (const report::ValidationSection& section : r.outcome.sections) data.sections.push_back(section);
    data.sources.push_back({r.title, r.source, r.note});
}

int writeReport(const report::ValidationData& data, const std::filesystem::path& folder) {
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    const std::filesystem::path file = folder / "validation.pdf";
    try {
        report::writeValidationReport(data, file.string());
    } catch (const std::runtime_error& e) {
        return run::tell(e.what()), run::kMachineFailed;
    }
    run::tell(file.string() + " written");
    return run::kDone;
}

}  // namespace

int runValidate(const run::Store& store, const ValidateOptions& o) {
    const ValidationContext context{store, files::assetFolder() / "validation"};
    report::ValidationData data;
    data.date = core::formatUtc(run::now()).substr(0, 10);
    data.program = std::string("build ").append(core::coreBuildId());
    int code = run::kDone;
    bool shortOfIt = false;
    run::print("case,kind,quantity,measured,reference,error,tolerance,result\n");
    for (const std::string& id : o.cases.empty() ? validationIds(context.folder) : o.cases) {
        const auto result = runValidation(context, id);
        if (!result) {
            run::tell(result.error().text());
            code = run::kBadRequest;
            continue;
        }
        for (const ValidationRow& row : result->outcome.rows) {
            run::print(csvRow(*result, row));
            shortOfIt = shortOfIt || !row.ok();
        }
        if (!result->outcome.trouble.empty()) {
            run::tell(id + ": " + result->outcome.trouble);
            run::print(fmt::format("{},{},,,,,,short\n", id, result->evidence));
            shortOfIt = true;
        }
        addTo(data, *result);
    }
    const int written = writeReport(data, o.out);
    if (code != run::kDone || written != run::kDone) return code != run::kDone ? code : written;
    return shortOfIt ? kShortOfTolerance : run::kDone;
}

}  // namespace sagara::tools
