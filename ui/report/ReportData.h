#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/LocalFrame.h"
#include "core/base/Planar.h"
#include "core/base/Utc.h"
#include "core/world/Area.h"
#include "core/world/Route.h"
#include "ui/chart/Contours.h"
#include "ui/chart/Marks.h"

/// What the report of one run shows. Plain values in SI and frame N; the page turns them into knots, degrees
/// and text.
namespace sagara::report {

using chart::ChartMark;
using chart::Contour;

struct TaskLine {
    std::string title;
    bool done = false;
    double time_s = 0.0;
};

/// One deduction, its value already in the unit it is shown in.
struct DeductionLine {
    double time_s = 0.0;
    std::string title;     ///< of the criterion: "Keep to the speeds"
    std::string quantity;  ///< "speed over ground"
    std::string unit;      ///< "kn"
    double value = 0.0;
    double limit = 0.0;
    double points = 0.0;
    bool failed = false;  ///< this one fails the run
    core::NorthEast place;
};

/// What one criterion cost in all, for the table of the rubric.
struct CriterionLine {
    std::string title;
    double weight = 0.0;
    double lost = 0.0;
};

/// The graded ship once a second or so.
struct TrackPoint {
    double time_s = 0.0;
    core::NorthEast position;
    double heading_rad = 0.0;  ///< in frame N
    double speedOverGround_mps = 0.0;
    double rudder_rad = 0.0;         ///< positive turns the bow to starboard
    std::vector<double> shafts_rps;  ///< port to starboard
    double roll_rad = 0.0;           ///< starboard side down is positive
    double underKeel_m = 0.0;
    double speedLimit_mps =
        0.0;  ///< in force here; 0: not known, then the limits of the route's legs are shown
};

/// Where and when an anchor was let go. Its own list, because the ship's track does not tell.
struct AnchorDrop {
    core::NorthEast position;
    double time_s = 0.0;
};

/// What the assessor said of the run.
struct AssessorNote {
    struct Overrule {
        double score = 0.0;
        bool passed = false;
        std::string reason;
    };
    std::string comment;
    std::optional<Overrule> overrule;  ///< in place of the automatic result
    std::string signedBy;              ///< empty: not signed off, room is left to sign by hand
    core::Utc signedAt;
};

struct OtherTrack {
    std::string name;
    bool hostile = false;
    std::vector<core::NorthEast> points;
};

struct RunReport {
    std::string scenarioName;
    std::string objective;
    std::string competenceCode;
    std::string shipName;
    std::string vesselName;
    std::string trainee;  ///< empty: nobody named
    std::string runType;  ///< "assess", "self-study", ...
    int level = 1;
    std::uint64_t seed = 0;
    core::Utc start;
    int utcOffset_min = 0;
    std::string timeZone;
    std::string weather;  ///< one line
    bool passed = false;
    std::string whyNot;  ///< empty when passed
    double score = 0.0;
    double passScore = 0.0;
    double duration_s = 0.0;
    std::string gradedFrom;  ///< "the run itself" or "the recorded track of another build"
    std::string stateHash;
    std::string buildId;
    std::optional<AssessorNote> assessor;
    std::vector<TaskLine> tasks;
    std::vector<CriterionLine> criteria;
    std::vector<DeductionLine> deductions;
    std::vector<TrackPoint> track;
    std::vector<AnchorDrop> anchors;
    double underKeelLimit_m = 0.0;  ///< drawn in its plot; 0: none
    double shipLength_m = 0.0;
    double shipBeam_m = 0.0;
    std::vector<OtherTrack> others;
    core::Route route;
    core::RoutePath path;
    core::LocalFrame frame{{}};
    std::string areaName;
    std::string chartNotice;  ///< "not for navigation ..."
    std::string depthDatum;
    std::vector<std::string> attribution;
    std::vector<std::vector<core::NorthEast>> land;  ///< closed rings
    std::vector<Contour> contours;                   ///< shallow to deep
    std::vector<ChartMark> marks;
};

/// Writes the report as PDF, A4. Throws std::runtime_error with a clear message when the file cannot be
/// written. Needs a QGuiApplication (the offscreen platform will do).
void writeReport(const RunReport& report, const std::string& path);

}  // namespace sagara::report
