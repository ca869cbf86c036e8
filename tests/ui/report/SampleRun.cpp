#include "tests/ui/report/SampleRun.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/base/Angle.h"
#include "tests/support/Assets.h"
#include "ui/chart/Contours.h"
#include "ui/chart/Marks.h"

namespace sagara::report::test {
namespace {

using chart::chartMarkOf;
using chart::contoursOf;
using core::kKnot_mps;
using core::NorthEast;

constexpr double kDraught_m = 2.7;
constexpr double kTide_m = 0.4;

const core::Area& galle() {
    static const core::Area area = [] {
        auto loaded = core::loadArea("area.json", sagara::test::readAsset("areas/galle/area.json"));
        if (!loaded) throw std::runtime_error(loaded.error().text());
        return std::move(loaded).value();
    }();
    return area;
}

const std::vector<Contour>& galleContours() {
    static const std::vector<Contour> contours =
        contoursOf(galle(), std::array{2.0, 5.0, 10.0, 15.0, 20.0, 30.0});
    return contours;
}

NorthEast local(double lat_deg, double lon_deg) { return galle().frame.toLocal({lat_deg, lon_deg}); }

/// As in assets/scenarios/basic-navigation.json.
core::Route lessonRoute() {
    struct Row {
        const char* name;
        double lat_deg, lon_deg, limit_M, speed_kn;
    };
    static constexpr std::array<Row, 8> kRows{{{"Off New Pier", 6.03225, 80.2302, 0.02, 6},
                                               {"Basin", 6.03275, 80.2286, 0.02, 6},
                                               {"Entrance", 6.03292, 80.22744, 0.02, 6},
                                               {"Outside", 6.03255, 80.2249, 0.05, 10},
                                               {"Bay turn", 6.0295, 80.225, 0.05, 10},
                                               {"Off fort light", 6.023, 80.2255, 0.05, 10},
                                               {"Leeward", 6.00458, 80.224904, 0.1, 10},
                                               {"Anchorage", 6.007185, 80.227506, 0.1, 3}}};
    core::Route route{"Galle: New Pier to the NE monsoon anchorage", {}};
    for (const Row& row : kRows) {
        const double limit_m = row.limit_M * core::kNauticalMile_m;
        route.waypoints.push_back({row.name, local(row.lat_deg, row.lon_deg), 0.075 * core::kNauticalMile_m,
                                   limit_m, limit_m, row.speed_kn * kKnot_mps});
    }
    return route;
}

NorthEast anchorMark() { return galle().findPlace("anch_ne_monsoon")->position; }

double limitAt_mps(NorthEast p, std::size_t leg) {
    const double off_M = core::distance(p, anchorMark()) / core::kNauticalMile_m;
    if (off_M < 0.2) return 3.0 * kKnot_mps;
    if (off_M < 0.5) return 6.0 * kKnot_mps;
    return (leg <= 2 ? 6.0 : 10.0) * kKnot_mps;
}

/// Sails the path with a helmsman's wobble. `carelessness` 0: keeps to everything.
class Sailor {
public:
    Sailor(RunReport& report, double carelessness) : m_report(report), m_careless(carelessness) {}

    void sail() {
        alongside(150.0);
        springOff(150.0);
        follow();
        anchor();
    }

private:
    NorthEast berth() const {
        const core::Berth& pier = *galle().findBerth("new-pier");
        return pier.face.a + 225.0 * pier.along() + 5.4 * pier.outward();
    }
    void alongside(double for_s) {
        for (double t_s = 0.0; t_s < for_s; ++t_s)
            add(berth(), 260.0 * core::kDegree_rad, 0.0, 0.0, {0.0, 0.0});
    }
    void springOff(double for_s) {
        const NorthEast from = berth(), to = m_report.path.pointAt(0.0);
        for (double t_s = 0.0; t_s < for_s; ++t_s) {
            const double part = t_s / for_s, eased = part * part * (3.0 - 2.0 * part);
            const double heading_deg = 260.0 + 26.0 * std::sin(core::kPi * std::min(1.0, 1.4 * part));
            add(from + eased * (to - from), heading_deg * core::kDegree_rad, 0.0, -0.35, {-110.0, 110.0});
        }
    }
    void follow() {
        double along_m = 0.0, speed_mps = 0.6;
        while (along_m < m_report.path.length_m() - 40.0) {
            const auto here = m_report.path.at(along_m);
            const NorthEast onPath = m_report.path.pointAt(along_m);
            m_leg = here.leg;
            const double limit_mps = limitAt_mps(onPath, here.leg);
            const double wanted_mps = limit_mps * (0.96 + 0.3 * m_careless * std::sin(along_m / 300.0));
            speed_mps += std::clamp(wanted_mps - speed_mps, -0.035, 0.025);
            const double off_m =
                (4.0 + 70.0 * m_careless) * std::sin(along_m / 310.0) * std::min(1.0, along_m / 300.0);
            const double course_rad = here.course_rad + off_m / 900.0;
            const NorthEast p = onPath + off_m * core::turnedRight(core::unitVector(here.course_rad));
            const double rudder_rad =
                std::clamp(60.0 * here.curvature_perM, -0.45, 0.45) + 0.03 * std::sin(0.21 * now_s());
            const double rpm = 95.0 * speed_mps + 10.0, split = 2200.0 * here.curvature_perM;
            add(p, course_rad, speed_mps, rudder_rad, {rpm + split, rpm - split});
            along_m += speed_mps;
        }
    }
    void anchor() {
        const TrackPoint last = m_report.track.back();
        const double drift_m = 95.0 + 60.0 * m_careless;
        m_report.anchors.push_back(
            {last.position + 25.0 * core::unitVector(last.heading_rad), last.time_s + 60.0});
        const NorthEast back = core::unitVector(last.heading_rad + core::kPi);
        for (double t_s = 0.0; t_s < 420.0; ++t_s) {
            const double laid_m = drift_m * (1.0 - std::exp(-t_s / 130.0));
            const double swing_rad = 0.15 * std::sin(t_s / 70.0);
            const double speed_mps = drift_m / 130.0 * std::exp(-t_s / 130.0);
            const double rpm = t_s < 60.0 ? -130.0 : 0.0;
            add(last.position + laid_m * back, last.heading_rad + swing_rad, speed_mps, 0.0, {rpm, rpm});
        }
    }
    double now_s() const { return m_report.track.empty() ? 0.0 : m_report.track.back().time_s + 1.0; }
    void add(NorthEast p, double heading_rad, double speed_mps, double rudder_rad,
             std::array<double, 2> shafts_rpm) {
        const double t_s = now_s();
        const double swell = std::clamp((1200.0 - p.north_m) / 900.0, 0.03, 1.0);
        TrackPoint point;
        point.time_s = t_s;
        point.position = p;
        point.heading_rad = core::wrapTwoPi(heading_rad);
        point.speedOverGround_mps = speed_mps;
        point.rudder_rad = rudder_rad;
        for (const double rpm : shafts_rpm) point.shafts_rps.push_back(rpm * core::kRpm_rps);
        point.roll_rad = swell * (0.05 * std::sin(0.52 * t_s) + 0.025 * std::sin(0.61 * t_s + 1.0));
        point.underKeel_m = galle().depth_m(p) + kTide_m - kDraught_m + 0.2 * swell * std::sin(0.47 * t_s);
        point.speedLimit_mps = limitAt_mps(p, m_leg);
        m_report.track.push_back(std::move(point));
    }

    RunReport& m_report;
    double m_careless;
    std::size_t m_leg = 1;
};

void addTraffic(RunReport& report) {
    const auto line = [](std::initializer_list<std::array<double, 2>> places) {
        std::vector<NorthEast> points;
        for (const auto& [lat, lon] : places) points.push_back(local(lat, lon));
        return points;
    };
    report.others = {
        {"MV Ruhunu", false,
         line({{5.985, 80.175},
               {6.013, 80.209},
               {6.0285, 80.2222},
               {6.03285, 80.2245},
               {6.03295, 80.2278},
               {6.0334, 80.2291}})},
        {"Sea Fortune", false,
         line({{6.0262, 80.2336},
               {6.0236, 80.2322},
               {6.0246, 80.2352},
               {6.0272, 80.2358},
               {6.0262, 80.2336},
               {6.0236, 80.2322}})},
        {"Nilmini", false, line({{6.02, 80.21}, {6.012, 80.2065}, {6.0105, 80.2015}})},
        {"Dilshan Putha", false, line({{6.03495, 80.22935}})},
        {"Unknown fast craft 1", true,
         line({{6.0125, 80.239}, {6.0129, 80.231}, {6.0111, 80.2275}, {6.0092, 80.229}, {6.0101, 80.236}})}};
}

void addLesson(RunReport& r) {
    r.scenarioName = "Basic Navigation";
    r.objective =
        "Take a patrol vessel from her berth through a narrow entrance to an anchorage, on time and without "
        "damage.";
    r.competenceCode = "STCW A-II/1: plan and conduct a passage; manoeuvre the ship";
    r.shipName = "SLNS Sagara";
    r.vesselName = "51.5 m patrol vessel (patrol51)";
    r.trainee = "Sub-Lieutenant A. B. Perera";
    r.runType = "assess";
    r.level = 3;
    r.seed = 20270115;
    r.start = *core::parseUtc("2027-01-15T03:30:00Z");
    r.utcOffset_min = 330;
    r.timeZone = "Asia/Colombo";
    r.weather = "wind NE 8 kn, gusting 10; swell SW 1.0 m 12 s; visibility 8 M";
    r.passScore = 70.0;
    r.gradedFrom = "the run itself";
    r.stateHash = "9f3a61c04be27d15";
    r.buildId = "sagara 0.1.0 (0002929)";
    r.shipLength_m = 51.5;
    r.shipBeam_m = 8.6;
    r.underKeelLimit_m = 1.5;
}

void addArea(RunReport& r) {
    const core::Area& area = galle();
    r.frame = area.frame;
    r.areaName = area.name;
    r.chartNotice = area.notice;
    r.depthDatum = area.depthDatum;
    r.attribution = area.attribution;
    r.land = area.land;
    r.contours = galleContours();
    for (const core::Mark& mark : area.marks) r.marks.push_back(chartMarkOf(mark, area.ialaRegion));
}

double timeOfWaypoint_s(const RunReport& r, std::size_t waypoint) {
    const auto nearest =
        std::min_element(r.track.begin(), r.track.end(), [&](const TrackPoint& a, const TrackPoint& b) {
            const NorthEast p = r.route.waypoints[waypoint].position;
            return core::distance(a.position, p) < core::distance(b.position, p);
        });
    return nearest->time_s;
}

RunReport sail(double carelessness) {
    RunReport r;
    addLesson(r);
    addArea(r);
    r.route = lessonRoute();
    r.path = core::RoutePath(r.route);
    Sailor(r, carelessness).sail();
    addTraffic(r);
    r.duration_s = r.track.back().time_s;
    r.tasks = {{"Single up and spring off", true, 196.0},
               {"All lines in and 20 m clear", true, 262.0},
               {"Pass the entrance", true, timeOfWaypoint_s(r, 2)},
               {"Transit to the anchorage", true, timeOfWaypoint_s(r, 7) - 90.0},
               {"Anchor and bring up", true, r.duration_s - 20.0}};
    r.criteria = {{"Keep to the route", 20, 0},
                  {"Keep to the speeds", 20, 0},
                  {"Be anchored in time", 20, 0},
                  {"Keep water under the keel", 15, 0},
                  {"Pass other ships well clear inside", 10, 0},
                  {"Pass other ships well clear outside", 15, 0},
                  {"Leave the berth gently", 15, 0},
                  {"Do no damage to berth and breakwaters", 100, 0},
                  {"Stay afloat", 100, 0},
                  {"Touch no other ship", 100, 0},
                  {"Break no line and no cable", 15, 0},
                  {"Let go on the mark", 15, 0},
                  {"Let go with slow sternway", 10, 0},
                  {"Do not drag", 15, 0}};
    return r;
}

void deduct(RunReport& r, std::size_t criterion, double time_s, const char* quantity, const char* unit,
            double value, double limit, double points, bool failed = false) {
    const auto at = static_cast<std::size_t>(std::clamp(time_s, 0.0, r.duration_s));
    r.criteria[criterion].lost += points;
    r.deductions.push_back({time_s, r.criteria[criterion].title, quantity, unit, value, limit, points, failed,
                            r.track[at].position});
}

}  // namespace

RunReport passedRun() {
    RunReport r = sail(0.0);
    r.passed = true;
    r.score = 100.0;
    return r;
}

RunReport failedRun() {
    RunReport r = sail(1.0);
    r.trainee = "Midshipman K. de Silva";
    r.tasks[4].done = false;
    deduct(r, 6, 156, "speed of contact", "m/s", 0.2312, 0.15, 5);
    deduct(r, 1, 402, "speed over ground", "kn", 6.13, 6.0, 4);
    deduct(r, 0, 446, "distance off track", "M", 0.02741, 0.02, 4);
    deduct(r, 1, 470, "speed over ground", "kn", 8.42, 6.0, 4);
    deduct(r, 4, 478, "distance to another ship", "m", 31.4, 50, 5);
    deduct(r, 0, 640, "distance off track", "M", 0.0512, 0.05, 4);
    deduct(r, 1, 760, "speed over ground", "kn", 11.7, 10.0, 4);
    deduct(r, 3, 705, "under-keel clearance", "m", 1.17, 1.5, 5);
    deduct(r, 5, 1130, "distance to another ship", "m", 212.0, 463, 5);
    deduct(r, 1, 1270, "speed over ground", "kn", 6.9, 6.0, 4);
    deduct(r, 11, r.duration_s - 360.0, "distance of the anchor from the mark", "m", 118.0, 50, 15);
    deduct(r, 12, r.duration_s - 360.0, "sternway at let go", "kn", -2.31, 0.3, 10);
    deduct(r, 13, r.duration_s - 150.0, "distance dragged", "m", 23.6, 10, 15, true);
    std::stable_sort(r.deductions.begin(), r.deductions.end(),
                     [](const DeductionLine& a, const DeductionLine& b) { return a.time_s < b.time_s; });
    r.passed = false;
    r.score = 16.0;
    r.whyNot = "Not every task was done: Anchor and bring up. The score is below the pass mark.";
    return r;
}

}  // namespace sagara::report::test
