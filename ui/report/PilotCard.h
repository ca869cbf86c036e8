#pragma once

#include <QPointF>
#include <string>
#include <vector>

/// Pilot card and wheelhouse poster of a ship, IMO resolution A.601(15), for simulation. Plain values in the
/// units that are printed.
namespace sagara::report {

struct PilotCardData {
    struct Row {
        std::string label;
        std::string value;
    };
    struct Step {
        std::string order;
        double shaft_rpm = 0.0;
        double speed_kn = 0.0;
    };
    struct Stop {
        std::string from;
        double speed_kn = 0.0;
        double time_s = 0.0;
        double reach_m = 0.0;  ///< ahead
        double side_m = 0.0;   ///< to starboard
    };
    /// How she turns and stops in one loading and one depth of water.
    struct Condition {
        std::string title;  ///< "Loaded, deep water"
        std::string note;   ///< what to know of it; empty: nothing
        double approach_kn = 0.0;
        std::vector<Row> turning;        ///< measures of the turning circles
        std::vector<Stop> stops;         ///< full astern from the steps ahead
        std::vector<QPointF> starboard;  ///< track of the turn: x transfer, y advance, m
        std::vector<QPointF> port;
        std::vector<QPointF> starboardTimes;  ///< places on the track each full minute
    };
    struct Check {
        std::string criterion;
        std::string value;
        std::string limit;
        bool met = false;
    };
    struct Source {
        std::string group;
        std::string quality;
        std::string source;
    };
    std::string ship;
    std::string type;
    std::string date;  ///< of the card
    std::vector<Row> particulars;
    std::vector<Row> anchors;
    std::vector<Row> steering;
    std::vector<Row> propulsion;
    std::vector<Step> telegraph;
    std::vector<Check> checks;          ///< against MSC.137(76)
    std::vector<Condition> conditions;  ///< a poster page each; the first is that of the card
    double length_m = 0.0;
    std::vector<Source> sources;
};

/// Writes it as PDF, A4, two pages or more. Throws std::runtime_error with a clear message when the file
/// cannot be written. Needs a QGuiApplication.
void writePilotCard(const PilotCardData& card, const std::string& path);

}  // namespace sagara::report
