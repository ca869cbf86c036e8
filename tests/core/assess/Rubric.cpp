#include "Rubric.h"

#include <stdexcept>

namespace sagara::core::test {
namespace {

Route::Waypoint waypoint(NorthEast position, double radius_m, double port_m, double starboard_m) {
    return {"", position, radius_m, port_m, starboard_m, 10.0};
}

template <typename Read>
auto read(const std::string& json, Read&& readRoot) {
    config::Document document("rubric", json);
    auto item = readRoot(document.root());
    if (!document.problems().empty()) throw std::runtime_error(document.problems().text());
    return item;
}

template <typename Read>
std::string problems(const std::string& json, Read&& readRoot) {
    config::Document document("rubric", json);
    (void)readRoot(document.root());
    return document.problems().text();
}

}  // namespace

Rubric::Rubric() {
    m_area.id = "test";
    m_area.places = {{"mark", "", "", {2000.0, 900.0}},
                     {"gate-west", "", "", {500.0, -100.0}},
                     {"gate-east", "", "", {500.0, 100.0}}};
    m_route.waypoints = {waypoint({0.0, 0.0}, 0.0, 1.0, 1.0), waypoint({1000.0, 0.0}, 0.0, 20.0, 30.0),
                         waypoint({2000.0, 0.0}, 200.0, 50.0, 60.0),
                         waypoint({2000.0, 1000.0}, 0.0, 100.0, 110.0)};
    m_path = RoutePath(m_route);
}

std::unique_ptr<const Task> Rubric::task(const std::string& json) const {
    return read(json, [&](const config::Node& node) { return readTask(node, context()); });
}
std::unique_ptr<const Criterion> Rubric::criterion(const std::string& json) const {
    return read(json, [&](const config::Node& node) { return readCriterion(node, context()); });
}
Mission Rubric::mission(const std::string& json) const {
    return read(json, [&](const config::Node& node) {
        config::Reader in(node);
        return readMission(in, context());
    });
}
std::string Rubric::problemsOfCriterion(const std::string& json) const {
    return problems(json, [&](const config::Node& node) { return readCriterion(node, context()); });
}
std::string Rubric::problemsOfTask(const std::string& json) const {
    return problems(json, [&](const config::Node& node) { return readTask(node, context()); });
}

std::string terms(const std::string& kindAndMore) {
    return R"({"id": "it", "title": "It", "weight": 10, "points": 4, "kind": )" + kindAndMore + "}";
}

bool Judge::breaks() {
    CriterionMemory fresh;
    std::vector<Deduction> found;
    criterion->observe(now, route, fresh, found);
    criterion->close(now.time, fresh, found);
    return !found.empty();
}

}  // namespace sagara::core::test
