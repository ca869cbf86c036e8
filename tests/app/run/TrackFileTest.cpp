#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <sstream>

#include "SimTest.h"

namespace sagara::run::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kColumns =
    "time_s,ship,lat_deg,lon_deg,north_m,east_m,heave_m,roll_deg,pitch_deg,heading_deg,surge_mps,sway_mps,"
    "yaw_rate_degps,rudder_deg,shaft_rpm,depth_under_keel_m,score";

class TrackFile : public SimTest {
protected:
    /// Rows of the track of a run, without the heading.
    std::vector<Arguments> rowsOf(const char* name) const {
        const std::vector<std::string> lines = linesOf(read(name));
        EXPECT_EQ(lines.at(0), kColumns);
        std::vector<Arguments> rows;
        for (std::size_t i = 1; i < lines.size(); ++i) {
            Arguments row;
            std::istringstream cells(lines[i]);
            for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
            EXPECT_EQ(row.size(), 17u) << lines[i];
            rows.push_back(row);
        }
        return rows;
    }
};

TEST_F(TrackFile, HasARowForEachSecondFromTheStartOn) {
    simDone(lesson("30", {"--helm", "pilot", "--track", at("track.csv")}));
    const auto rows = rowsOf("track.csv");
    ASSERT_EQ(rows.size(), 31u);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(std::stod(rows[i][0]), static_cast<double>(i));
        EXPECT_EQ(rows[i][1], "own");
        for (std::size_t k = 2; k < rows[i].size(); ++k) EXPECT_TRUE(std::isfinite(std::stod(rows[i][k])));
    }
    EXPECT_NEAR(std::stod(rows[0][2]), 6.0320, 0.001);
    EXPECT_NEAR(std::stod(rows[0][3]), 80.2304, 0.001);
    EXPECT_NEAR(std::stod(rows[0][9]), 260.0, 1.0);  // her berth
    EXPECT_EQ(std::stod(rows[0][16]), 100.0);
}

TEST_F(TrackFile, HasAsManyRowsASecondAsAskedFor) {
    simDone(lesson("4", {"--track", at("fine.csv"), "--track-hz", "5"}));
    const auto fine = rowsOf("fine.csv");
    ASSERT_EQ(fine.size(), 21u);
    EXPECT_EQ(std::stod(fine[1][0]), 0.2);
    simDone(lesson("20", {"--track", at("coarse.csv"), "--track-hz", "0.1"}));
    EXPECT_EQ(rowsOf("coarse.csv").size(), 3u);
}

TEST_F(TrackFile, MayBeAPipeOrALinkWhichStaysOne) {
    ASSERT_EQ(::mkfifo(at("pipe").c_str(), 0600), 0);
    const int pipe = ::open(at("pipe").c_str(), O_RDWR | O_NONBLOCK);  // holds more than these rows
    simDone(lesson("3", {"--track", at("pipe"), "--record", at("run.sgr")}));
    char head[7] = {};
    EXPECT_EQ(::read(pipe, head, 6), 6);
    EXPECT_STREQ(head, "time_s");
    ::close(pipe);
    EXPECT_TRUE(fs::is_fifo(at("pipe")));
    fs::create_symlink("real.csv", at("link.csv"));
    simDone({"replay", at("run.sgr"), "--track", at("link.csv")});
    EXPECT_TRUE(fs::is_symlink(at("link.csv")));
    EXPECT_EQ(rowsOf("real.csv").size(), 4u);
}

TEST_F(TrackFile, OfAReplayIsTheSame) {
    simDone(lesson("12", {"--helm", "pilot", "--track", at("run.csv"), "--record", at("run.sgr")}));
    simDone({"replay", at("run.sgr"), "--track", at("replay.csv")});
    EXPECT_EQ(read("replay.csv"), read("run.csv"));
    simDone({"replay", at("run.sgr"), "--track", at("part.csv"), "--until-s", "5", "--track-hz", "2"});
    EXPECT_EQ(rowsOf("part.csv").size(), 11u);
}

}  // namespace
}  // namespace sagara::run::test
