#include "../run/SimTest.h"

namespace sagara::run::test {
namespace {

constexpr const char* kHull = SAGARA_TEST_DATA "/seakeeping/dtmb5415_hull.json";

class SeakeepingTools : public SimTest {};

TEST_F(SeakeepingTools, RaoTakesFrequenciesOrWavelengthsOfAHullFile) {
    const auto byLength = linesOf(simDone({"rao", "--hull", kHull, "--speed-mps", "10.4", "--heading-deg",
                                           "180", "--lambda-over-L", "1,1.5"})
                                      .out);
    ASSERT_EQ(byLength.size(), 3u);
    EXPECT_EQ(byLength.front().rfind(
                  "omega_radps,omega_e_radps,lambda_over_L,surge,sway,heave,roll_k,pitch_k,yaw_k,"
                  "surge_phase_deg,",
                  0),
              0u);
    const std::string omega = byLength[1].substr(0, byLength[1].find(','));
    const auto byFrequency = linesOf(simDone({"rao", "--hull", kHull, "--speed-mps", "10.4", "--omega", omega,
                                              "--wave-height-m", "2", "--csv", at("rao.csv")})
                                         .out);
    EXPECT_TRUE(byFrequency.empty() || byFrequency.front().empty());
    EXPECT_EQ(linesOf(read("rao.csv")).size(), 2u);
}

TEST_F(SeakeepingTools, RaoAndHydrostaticsTakeAVessel) {
    EXPECT_EQ(linesOf(simDone({"rao", "--vessel", "kvlcc2", "--heading-deg", "90", "--omega", "0.3,0.4"}).out)
                  .size(),
              3u);
    const std::string report = simDone({"hydrostatics", "--vessel", "kvlcc2"}).out;
    EXPECT_NE(report.find("name,value\nvolume_m3,311"), std::string::npos) << report;
    EXPECT_NE(report.find("gm_transverse_m,5.71"), std::string::npos) << report;
    EXPECT_NE(report.find("gz_m_at_30_deg,"), std::string::npos) << report;
}

TEST_F(SeakeepingTools, WhatCannotBeAnsweredIsRefused) {
    EXPECT_EQ(sim({"rao", "--hull", kHull}).exitCode, 2);
    EXPECT_EQ(sim({"rao", "--omega", "0.5"}).exitCode, 2);
    EXPECT_EQ(sim({"rao", "--hull", kHull, "--vessel", "kvlcc2", "--omega", "0.5"}).exitCode, 2);
    EXPECT_EQ(sim({"rao", "--hull", at("none.json"), "--omega", "0.5"}).exitCode, 2);
    write("bad.json", R"({"length_pp_m": 100, "breadth_m": 20})");
    const Outcome bad = sim({"hydrostatics", "--hull", at("bad.json")});
    EXPECT_EQ(bad.exitCode, 2);
    EXPECT_NE(bad.err.find("draught_m is missing"), std::string::npos) << bad.err;
}

}  // namespace
}  // namespace sagara::run::test
