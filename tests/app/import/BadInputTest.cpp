#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "app/import/AreaImport.h"
#include "tests/support/Assets.h"

namespace sagara::importer {
namespace {

namespace fs = std::filesystem;

/// A copy of the sources of Galle that a test may spoil.
class BadInput : public ::testing::Test {
protected:
    void SetUp() override {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        m_folder = fs::path(::testing::TempDir()) / (std::string("sagara-import-") + test->name());
        fs::remove_all(m_folder);
        fs::copy(fs::path(SAGARA_ASSETS) / "areas/galle", m_folder);
        fs::remove(m_folder / "area.json");
    }
    void TearDown() override { fs::remove_all(m_folder); }

    void write(const std::string& file, const std::string& text) { std::ofstream(m_folder / file) << text; }
    void replace(const std::string& file, const std::string& from, const std::string& to) {
        std::string text = test::readFile((m_folder / file).string());
        const std::size_t place = text.find(from);
        ASSERT_NE(place, std::string::npos) << from;
        write(file, text.replace(place, from.size(), to));
    }
    std::string problems() {
        const auto made =
            importArea("import.json", test::readFile((m_folder / "import.json").string()), m_folder);
        return made ? "" : made.error().text();
    }
    /// Exit code of the program.
    int run(const std::string& arguments) {
        const std::string quiet = " >/dev/null 2>\"" + (m_folder / "errors").string() + "\"";
        const int status = std::system((std::string(SAGARA_IMPORT) + " " + arguments + quiet).c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string path(const char* file) { return (m_folder / file).string(); }

    fs::path m_folder;
};

TEST_F(BadInput, DescriptionThatIsNotJsonSaysWhere) {
    write("import.json", "{ \"document\": \n oops");
    EXPECT_EQ(problems().rfind("import.json: is not JSON (parse error at line 2, column 2", 0), 0u)
        << problems();
}

TEST_F(BadInput, EveryProblemOfTheDescriptionIsNamedAtOnce) {
    replace("import.json", "\"profileExponent\": 0.6666666666666667", "\"profileExponent\": \"two thirds\"");
    replace("import.json", "\"kind\": \"breakwater\"", "\"kind\": \"mole\"");
    replace("import.json", "\"waveLength_m\": 100", "\"waveLenght_m\": 100");
    replace("import.json", "\"depth_m\": 8.9", "\"depth_m\": -8.9");
    replace("import.json", "\"datum\":", "\"tide\": {}, \"datum\":");
    EXPECT_EQ(
        problems(),
        "import.json: area.tide is made by the importer, expected members that are taken over as they stand\n"
        "import.json: shoreline.categories[0].kind is \"mole\", expected one of quay, jetty, breakwater, "
        "rock, "
        "beach, other\n"
        "import.json: depth.profileExponent is \"two thirds\", expected 0.1 to 2\n"
        "import.json: shelter.waveLength_m is missing, expected 1 to 1000 m\n"
        "import.json: shelter.waveLenght_m is unknown, expected one of grids, sectors, step_deg, unit, "
        "waveLength_m\n"
        "import.json: berths[0].depth_m is -8.9, expected 0.5 to 40 m");
}

TEST_F(BadInput, GridsMustBeNested) {
    replace("import.json", "\"west_deg\": 80.2205", "\"west_deg\": 80.1705");
    replace("import.json", "\"spacing_m\": 10", "\"spacing_m\": 20");
    EXPECT_EQ(problems(),
              "import.json: depth.grids[0].box reaches beyond the next grid, expected each grid inside the "
              "next and the "
              "last inside box\n"
              "import.json: shelter.grids[0].spacing_m is not below that of the next grid, expected the "
              "finest grid first");
}

TEST_F(BadInput, GridsMustHaveASaneSize) {
    replace("import.json", "\"spacing_m\": 90", "\"spacing_m\": 2");
    EXPECT_EQ(problems(),
              "import.json: elevation makes 8293 by 8301 nodes, expected 2 to 5000 nodes along each side");
}

TEST_F(BadInput, EveryMissingSourceIsNamedAtOnce) {
    for (const char* file :
         {"galle_land_detail.geojson", "galle_srtm3_dem.tif", "tide_colombo_harmonics.json"}) {
        fs::remove(m_folder / file);
    }
    const std::string at = m_folder.string() + "/";
    EXPECT_EQ(problems(),
              "galle_land_detail.geojson: is missing, expected a file at " + at +
                  "galle_land_detail.geojson\n"
                  "tide_colombo_harmonics.json: cannot be read (no such file), expected a file at " +
                  at + "tide_colombo_harmonics.json\ngalle_srtm3_dem.tif: is missing, expected a file at " +
                  at + "galle_srtm3_dem.tif");
}

TEST_F(BadInput, UnknownCategoryNamesTheFeature) {
    replace("galle_shoreline_detail.geojson", "\"category\":\"jetty\"", "\"category\":\"pontoon\"");
    EXPECT_EQ(problems(),
              "galle_shoreline_detail.geojson: features[1].category is \"pontoon\", expected one of "
              "breakwater, jetty, "
              "quay, fort_rampart, rock_cliff, beach, beach_or_revetment, natural_unspecified "
              "(shoreline.categories of "
              "the description)");
}

TEST_F(BadInput, GeoJsonInAnotherReferenceSystemIsRefused) {
    replace("galle_land_context.geojson", "\"name\":\"galle_land_context\"",
            R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::32644"}})");
    EXPECT_EQ(
        problems(),
        "galle_land_context.geojson: has the reference system WGS 84 / UTM zone 44N, expected WGS 84 degrees "
        "(EPSG:4326)");
}

TEST_F(BadInput, GeoJsonOfAnotherShapeIsRefused) {
    write("galle_land_detail.geojson", R"({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [80.2, 6.0]}},
        {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
            [[[80, 6], [81, 6], [81, 7], [80, 6]], [[80.5, 6.1], [80.6, 6.1], [80.6, 6.2], [80.5, 6.1]]]}}]})");
    write("galle_named_features.geojson", "[]");
    EXPECT_EQ(
        problems(),
        "galle_land_detail.geojson: features[0] is a POINT, expected a polygon without holes, or several\n"
        "galle_land_detail.geojson: features[1] is a POLYGON, expected a polygon without holes, or several\n"
        "galle_named_features.geojson: cannot be read (`" +
            path("galle_named_features.geojson") +
            "' not recognized as a supported file format.), expected GeoJSON");
}

/// A GeoTIFF of 3 by 3 cells about Galle.
void writeTiff(const fs::path& file, int epsg, double west, double north, double cell) {
    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    GDALDatasetUniquePtr raster(driver->Create(file.c_str(), 3, 3, 1, GDT_Int16, nullptr));
    std::array<double, 6> transform{west, cell, 0.0, north, 0.0, -cell};
    raster->SetGeoTransform(transform.data());
    OGRSpatialReference reference;
    reference.importFromEPSG(epsg);
    raster->SetSpatialRef(&reference);
}

TEST_F(BadInput, ElevationInAnotherReferenceSystemIsRefused) {
    writeTiff(m_folder / "galle_srtm3_dem.tif", 32644, 400e3, 670e3, 10e3);
    EXPECT_EQ(problems(),
              "galle_srtm3_dem.tif: has the reference system WGS 84 / UTM zone 44N, expected WGS 84 degrees "
              "(EPSG:4326)");
}

TEST_F(BadInput, ElevationMustCoverItsBox) {
    writeTiff(m_folder / "galle_srtm3_dem.tif", 4326, 80.125, 6.125, 0.0625);
    EXPECT_EQ(problems(),
              "galle_srtm3_dem.tif: covers 5.96875 to 6.09375 N, 80.15625 to 80.28125 E, expected at least "
              "5.95 to 6.1 N, "
              "80.15 to 80.3 E");
    write("galle_srtm3_dem.tif", "no picture");
    EXPECT_EQ(problems().rfind("galle_srtm3_dem.tif: cannot be read (", 0), 0u) << problems();
}

TEST_F(BadInput, TideTableIsChecked) {
    replace("tide_colombo_harmonics.json", "\"amplitude_unit\": \"m\"", "\"amplitude_unit\": \"ft\"");
    replace("tide_colombo_harmonics.json", "\"phase\": 244.16673278808594", "\"phase\": 1e4");
    EXPECT_EQ(
        problems(),
        "tide_colombo_harmonics.json: amplitude_unit is \"ft\", expected one of m\n"
        "tide_colombo_harmonics.json: harmonic_constituents[0].phase is 10000, expected -360 to 360 deg");
}

TEST_F(BadInput, BerthsMustLieOnTheShoreTheRightWayRound) {
    replace(
        "import.json",
        "\"a\": { \"lat\": 6.032207, \"lon\": 80.232416 }, \"b\": { \"lat\": 6.031537, \"lon\": 80.22873 }",
        "\"b\": { \"lat\": 6.032207, \"lon\": 80.232416 }, \"a\": { \"lat\": 6.031537, \"lon\": 80.22873 }");
    replace("import.json", "\"lat\": 6.033988, \"lon\": 80.230316", "\"lat\": 6.0339, \"lon\": 80.230316");
    EXPECT_EQ(problems(),
              "import.json: berths[0].a to b has the land on its right hand, expected the water on the right "
              "hand from a "
              "to b\n"
              "import.json: berths[1].a to b runs up to 9.7 m off the shoreline, expected a face at most 1 m "
              "off it");
}

TEST_F(BadInput, TheLoaderChecksWhatIsTakenOver) {
    replace("import.json", "\"ialaRegion\": \"A\"", "\"ialaRegion\": \"C\"");
    replace("import.json", "\"kind\": \"safe-water\"", "\"kind\": \"fairway\"");
    EXPECT_EQ(
        problems().rfind("import.json (the area made from it): ialaRegion is \"C\", expected one of A, B\n"
                         "import.json (the area made from it): marks[5].kind is \"fairway\", expected one of",
                         0),
        0u)
        << problems();
}

TEST_F(BadInput, TheProgramExitsWithTwoAndWritesNothing) {
    replace("import.json", "\"version\": 1", "\"version\": 2");
    EXPECT_EQ(run(path("import.json") + " --out " + path("area.json")), 2);
    EXPECT_EQ(test::readFile(path("errors")),
              "import.json: version is 2, expected a whole number from 1 to 1\n");
    EXPECT_FALSE(fs::exists(path("area.json")));
    EXPECT_EQ(run(path("nothing.json") + " --out " + path("area.json")), 2);
    EXPECT_EQ(run(path("import.json")), 2);  // no --out
}

TEST_F(BadInput, AnOldDocumentSurvivesABadRunAndNoPartIsLeft) {
    write("area.json", "old");
    replace("import.json", "\"version\": 1", "\"version\": 2");
    EXPECT_EQ(run(path("import.json") + " --out " + path("area.json")), 2);
    EXPECT_EQ(test::readFile(path("area.json")), "old");
    EXPECT_FALSE(fs::exists(path("area.json.part")));
}

TEST_F(BadInput, AFolderThatIsNotThereIsNamed) {
    EXPECT_EQ(run(path("import.json") + " --out " + path("nowhere/area.json")), 2);
    EXPECT_EQ(test::readFile(path("errors")),
              "area.json: cannot be written (No such file or directory), expected a file at " +
                  path("nowhere/area.json") + "\n");
}

}  // namespace
}  // namespace sagara::importer
