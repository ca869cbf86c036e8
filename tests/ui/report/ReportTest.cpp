#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/base/Angle.h"
#include "tests/support/Assets.h"
#include "tests/ui/report/PdfReader.h"
#include "tests/ui/report/SampleRun.h"
#include "ui/report/Format.h"

namespace sagara::report::test {
namespace {

using core::NorthEast;

const std::string kLongName =
    "A lesson with a name that somebody wrote without thinking of paper, forms or anybody who has to read it "
    "aloud in a "
    "debriefing, about entering, leaving, turning, mooring, towing, anchoring and searching in restricted "
    "visibility";

/// A document that is a PDF, opens, has as many pages as it says, and says "advisory" on each.
std::vector<std::string> soundPages(const RunReport& report, const std::string& name, std::size_t pages) {
    const auto pdf = written(report, name);
    EXPECT_EQ(sagara::test::readFile(pdf.string()).substr(0, 5), "%PDF-");
    EXPECT_EQ(countedPages(pdf), pages) << name;
    if (!canReadPdf()) return {};
    const std::vector<std::string> texts = pagesOf(pdf);
    EXPECT_EQ(texts.size(), pages) << name;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        EXPECT_NE(texts[i].find("automatic score, advisory"), std::string::npos)
            << name << ", page " << i + 1;
        const std::string number = "page " + std::to_string(i + 1) + " of " + std::to_string(texts.size());
        EXPECT_NE(texts[i].find(number), std::string::npos) << name;
    }
    return texts;
}

std::string joined(const std::vector<std::string>& pages) {
    std::string all;
    for (const std::string& page : pages) all += page + "\n";
    return all;
}

void expectText(const std::vector<std::string>& pages, const std::string& words) {
    if (pages.empty()) return;  // no pdftotext here
    EXPECT_NE(joined(pages).find(words), std::string::npos) << words;
}

void addDeductions(RunReport& report, int count) {
    for (int i = 0; i < count; ++i) {
        const double part = (i + 0.5) / count;
        const auto at = static_cast<std::size_t>(part * static_cast<double>(report.track.size()));
        report.deductions.push_back({report.track[at].time_s, "Keep to the speeds", "speed over ground", "kn",
                                     6.15 + 0.31 * i, 6.0, 1.0, i == 20, report.track[at].position});
    }
}

TEST(Report, APassedRunHasFourPagesAndSaysSo) {
    const RunReport run = passedRun();
    const auto pages = soundPages(run, "passed", 4);
    expectText(pages, "PASSED");
    EXPECT_EQ(joined(pages).find("NOT PASSED"), std::string::npos);
    for (const TaskLine& task : run.tasks) expectText(pages, task.title);
    for (const CriterionLine& line : run.criteria) expectText(pages, line.title);
    expectText(pages, "No points were deducted.");
    expectText(pages, "15 January 2027, 09:00 (Asia/Colombo, UTC+05:30)");
    expectText(pages, "15 January 2027, 03:30 UTC");
    expectText(pages, run.stateHash);
    expectText(pages, "NOT FOR NAVIGATION");
    expectText(pages, "080°13.5'E");
}

TEST(Report, AFailedRunListsEveryDeductionWithItsValueLimitAndPlace) {
    const RunReport run = failedRun();
    const auto pages = soundPages(run, "failed", 4);
    expectText(pages, "NOT PASSED");
    expectText(pages, "not done");
    if (pages.empty()) GTEST_SKIP() << "pdftotext is not installed";
    for (const DeductionLine& line : run.deductions) {
        const ValueAndLimit shown = valueAndLimit(line);
        expectText({pages.back()}, shown.value.toStdString());
        expectText({pages.back()}, shown.limit.toStdString());
        expectText({pages.back()}, clockTime(line.time_s).toStdString());
        const core::GeoPoint place = run.frame.toGeo(line.place);
        expectText({pages.back()}, latitude(place.lat_deg, 3).toStdString());
        expectText({pages.back()}, longitude(place.lon_deg, 3).toStdString());
    }
}

TEST(Report, TheAssessorsCommentOverrulingAndSignatureArePrinted) {
    RunReport run = failedRun();
    run.assessor = AssessorNote{"Kept a good look-out.\nBrake earlier at waypoint 5.",
                                AssessorNote::Overrule{72.0, true, "The squall came out of season."},
                                "Commander A. Silva",
                                {1800014400}};
    const auto pages = soundPages(run, "overruled", 4);
    expectText(pages, "PASSED");
    expectText(pages, "assessor: 72 of 100");
    expectText(pages, "This overrules the automatic result (not passed");
    expectText(pages, "Reason: The squall came out of season.");
    expectText(pages, "Brake earlier at waypoint 5.");
    expectText(pages, "Commander A. Silva");
    expectText(pages, "signed off in Sagara");
    expectText(pages, "15 January 2027, 12:00 UTC");
    EXPECT_EQ(joined(pages).find("NOT PASSED"), std::string::npos);
}

TEST(Report, ASignatureWithoutOverrulingConfirmsTheAutomaticResult) {
    RunReport run = passedRun();
    run.assessor = AssessorNote{"", {}, "A. Silva", {1800014400}};
    const auto pages = soundPages(run, "signed", 4);
    expectText(pages, "as graded automatically");
    EXPECT_EQ(joined(pages).find("not yet competent"), std::string::npos);
}

TEST(Report, ACommentThatWasNotSignedLeavesRoomToSign) {
    RunReport run = passedRun();
    run.assessor = AssessorNote{"A draft.", {}, "", {}};
    const auto pages = soundPages(run, "draft", 4);
    expectText(pages, "A draft.");
    expectText(pages, "not signed off");
    expectText(pages, "Assessor: name and signature");
}

TEST(Report, ALongCommentRunsOverPages) {
    RunReport run = passedRun();
    std::string comment;
    for (int i = 0; i < 40; ++i) comment += "Paragraph " + std::to_string(i) + ": " + kLongName + "\n";
    run.assessor = AssessorNote{comment, {}, "A. Silva", {1800014400}};
    const auto pdf = written(run, "long-comment");
    EXPECT_GE(countedPages(pdf), 5u);
    if (canReadPdf()) expectText(pagesOf(pdf), "Paragraph 39");
}

TEST(Report, AnEmptyReportIsStillADocument) {
    const auto pages = soundPages({}, "empty", 4);
    expectText(pages, "NOT PASSED");
    expectText(pages, "No track was recorded");
    expectText(pages, "No points were deducted.");
}

TEST(Report, ARunWithoutATrackShowsTheRouteAndSaysSo) {
    RunReport run = passedRun();
    run.track.clear();
    expectText(soundPages(run, "no-track", 4), "No track was recorded");
}

TEST(Report, ATrackOfOnePointIsEnough) {
    RunReport run = passedRun();
    run.track.resize(1);
    run.duration_s = 0.0;
    soundPages(run, "one-point", 4);
}

TEST(Report, WithoutRouteTasksCriteriaAndChartDataItStillReads) {
    RunReport run = passedRun();
    run.route = {};
    run.path = {};
    run.tasks.clear();
    run.criteria.clear();
    run.land.clear();
    run.contours.clear();
    run.marks.clear();
    run.others.clear();
    run.anchors.clear();
    const auto pages = soundPages(run, "bare", 4);
    expectText(pages, "This lesson has no tasks.");
    expectText(pages, "This lesson has no criteria.");
}

TEST(Report, SixtyDeductionsBreakOverPages) {
    RunReport run = passedRun();
    addDeductions(run, 60);
    const auto pages = soundPages(run, "sixty", 6);
    expectText(pages, "Deductions, continued");
    expectText(pages, "24.4 kn");  // the last but one
    expectText(pages, "60");
}

TEST(Report, ManyDeductionsInOnePlaceShareOneSymbol) {
    RunReport run = passedRun();
    addDeductions(run, 30);
    for (DeductionLine& line : run.deductions) {
        line.place = run.track[600].position;
        line.time_s = 600.0;
    }
    expectText(soundPages(run, "one-place", 5), "1–30");
}

TEST(Report, LongTextsWrapAndEndInAnEllipsis) {
    RunReport run = failedRun();
    run.scenarioName = kLongName;
    run.objective = kLongName + ". " + kLongName + ".";
    run.trainee = "Lieutenant Commander " + std::string(60, 'W') + " of the very long name";
    run.weather = kLongName;
    run.whyNot = kLongName;
    for (TaskLine& task : run.tasks) task.title = kLongName;
    for (CriterionLine& line : run.criteria) line.title += ", " + kLongName.substr(0, 90);
    for (DeductionLine& line : run.deductions) line.title = kLongName;
    for (core::Route::Waypoint& w : run.route.waypoints) w.name += " with quite a long name for a waypoint";
    const auto pdf = written(run, "long");
    EXPECT_GE(countedPages(pdf), 5u);
}

TEST(Report, FortyTasksAndCriteriaGoOverSeveralPages) {
    RunReport run = passedRun();
    for (int i = 6; i <= 40; ++i) {
        run.tasks.push_back({"Task number " + std::to_string(i), i % 3 != 0, 40.0 * i});
        run.criteria.push_back({"Criterion number " + std::to_string(i), 10, 0});
    }
    const auto pdf = written(run, "forty");
    EXPECT_GE(countedPages(pdf), 5u);
    if (canReadPdf()) expectText(pagesOf(pdf), "Task number 40");
}

/// A square of tracks leaves no corner free: the inset goes below the chart.
TEST(Report, ATrackAllOverTheChartPutsTheInsetBelow) {
    RunReport run = passedRun();
    run.route = {};
    run.path = {};
    run.anchors.clear();
    for (std::size_t i = 0; i < run.track.size(); ++i) {
        const double turn = 0.05 * static_cast<double>(i), reach_m = 1.2 * static_cast<double>(i);
        run.track[i].position =
            NorthEast{-1500.0, 0.0} + NorthEast{reach_m * std::cos(turn), 0.8 * reach_m * std::sin(turn)};
    }
    soundPages(run, "spiral", 4);
}

TEST(Report, SouthWestOfGreenwichWithOneShaftAndHoursAtSea) {
    RunReport run = passedRun();
    run.frame = core::LocalFrame({-33.9, -18.4});
    for (TrackPoint& p : run.track) {
        p.time_s *= 9.0;
        p.shafts_rps.resize(1);
        p.heading_rad = core::wrapTwoPi(p.heading_rad + 0.6 * std::sin(p.time_s / 300.0) + 1.7);
    }
    run.duration_s *= 9.0;
    run.deductions.push_back(
        {9000.0, "Keep to the speeds", "", "", 1.0, 0.0, 2.5, false, run.track[900].position});
    expectText(soundPages(run, "south-west", 4), "W");
}

TEST(Report, ValuesThatAreNotNumbersLeaveGaps) {
    RunReport run = passedRun();
    for (std::size_t i = 300; i < 400; ++i) {
        run.track[i].speedOverGround_mps = run.track[i].underKeel_m =
            std::numeric_limits<double>::quiet_NaN();
        run.track[i].heading_rad = run.track[i].roll_rad = std::numeric_limits<double>::infinity();
    }
    run.track[500].shafts_rps.clear();
    run.track[501].shafts_rps = {1.0, 1.0, 2.0};
    run.track[700].position.north_m = run.track[701].time_s = std::numeric_limits<double>::quiet_NaN();
    run.deductions = failedRun().deductions;
    run.deductions.at(3).place.east_m = run.deductions.at(4).value = std::numeric_limits<double>::quiet_NaN();
    run.duration_s = std::numeric_limits<double>::quiet_NaN();
    soundPages(run, "gaps", 4);
}

TEST(Report, ScriptsOtherThanLatinAreDrawn) {
    RunReport run = passedRun();
    run.trainee = "ඒ. බී. පෙරේරා / ஏ. பி. பெரேரா";
    soundPages(run, "scripts", 4);
}

TEST(Report, AnUnwritablePathGivesAMessageThatNamesItAndTheReason) {
    try {
        writeReport(passedRun(), "/nowhere/at/all/report.pdf");
        FAIL() << "it was written";
    } catch (const std::runtime_error& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.find("cannot write the report to /nowhere/at/all/report.pdf: "), 0u) << message;
        EXPECT_NE(message.find("No such file"), std::string::npos) << message;
    }
}

TEST(Report, AFolderInThePlaceOfTheFileGivesAMessage) {
    EXPECT_THROW(writeReport(passedRun(), outFolder().string()), std::runtime_error);
}

}  // namespace
}  // namespace sagara::report::test
