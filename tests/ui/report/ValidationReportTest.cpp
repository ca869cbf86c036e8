#include "ui/report/ValidationReport.h"

#include <gtest/gtest.h>

#include "tests/ui/report/PdfReader.h"

namespace sagara::report {
namespace {

ValidationData sample() {
    XyPlot plot;
    plot.title = "Turn to port";
    plot.xTitle = "to starboard, m";
    plot.yTitle = "ahead, m";
    plot.sameScale = true;
    plot.series = {{"Sagara", false, {{0, 0}, {-5, 10}, {-12, 4}}}, {"published", true, {{-4, 8}}}};
    plot.note = "From a note below the key.";
    SectionTable table{
        "Table I", {{"Model"}, {"Sway"}}, {{{"MMG", "of Yasukawa"}, {"yes", "8 deg"}}}, "By a rule."};
    ValidationData data;
    data.date = "2026-11-22";
    data.rows = {{"A turn", "verification", "track", "0.001", "0", "0.001", "0.002", true},
                 {"A roll", "validation", "damping", "50", "0", "50", "40", false}};
    data.plots = {plot};
    data.sections = {
        {"Founding paper", {{"Side by side", {"Text before the table."}, {table}, {plot, plot}}}}};
    data.sources = {{"A turn", "a paper of 2015", "claimed in deep water"}};
    return data;
}

TEST(ValidationReport, HasRowsPlotsSectionsAndSourcesAndNamesWhatIsShort) {
    const auto path = test::outFolder() / "validation.pdf";
    writeValidationReport(sample(), path.string());
    ASSERT_EQ(test::countedPages(path), 4u);
    if (!test::canReadPdf()) GTEST_SKIP() << "no pdftotext";
    const auto pages = test::pagesOf(path);
    const auto has = [&](std::size_t page, const char* words) {
        EXPECT_NE(pages.at(page).find(words), std::string::npos) << words << " in\n" << pages.at(page);
    };
    has(0, "1 of 2 within tolerance");
    has(0, "Short: A roll, damping");
    has(1, "From a note below the key.");
    for (const char* words :
         {"Side by side", "Text before the table.", "Table I", "of Yasukawa", "8 deg", "By a rule."})
        has(2, words);
    has(3, "claimed in deep water");
}

}  // namespace
}  // namespace sagara::report
