#include <gtest/gtest.h>

#include <algorithm>

#include "app/import/AreaImport.h"
#include "tests/support/Assets.h"

namespace sagara::importer {
namespace {

const std::string kFolder = std::string(SAGARA_ASSETS) + "/areas/galle";

bool reports(const std::vector<std::string>& report, const std::string& text) {
    return std::any_of(report.begin(), report.end(),
                       [&](const auto& line) { return line.find(text) != line.npos; });
}

TEST(GalleImport, TheCommittedDocumentIsWhatTheImporterMakes) {
    const auto made = importArea("import.json", test::readAsset("areas/galle/import.json"), kFolder);
    ASSERT_TRUE(made) << made.error().text();
    // Not EXPECT_EQ: two megabytes of difference help nobody.
    EXPECT_TRUE(made->document == test::readAsset("areas/galle/area.json"))
        << "run: sagara-import assets/areas/galle/import.json --out assets/areas/galle/area.json";
    EXPECT_LT(made->document.size(), 2'500'000u);
    EXPECT_TRUE(reports(made->report, "not known to the simulator: M1, MA2, MB2, T3, R3, 3L2, 2MK5, 2MO5"));
    EXPECT_TRUE(reports(made->report, "below 0.001 m: R2, MKS2, N4, M8, S3"));
    EXPECT_TRUE(reports(made->report, "10 m reported, 5.7 m by the profile, 10 m in the model"));
}

}  // namespace
}  // namespace sagara::importer
