#include "core/world/Streams.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

constexpr double kHour_s = 3600.0;

/// Linear between the hours; between six hours after one high water and six before the next, from the one to
/// the other.
template <typename T>
T atHour(const std::array<T, 13>& byHour, const TidalClock& clock) {
    const auto inside = [&](double hour) {
        const double place = std::clamp(hour + kHighWaterHour, 0.0, 12.0);
        const auto low = std::min(static_cast<std::size_t>(place), std::size_t{11});
        return byHour[low] + (place - static_cast<double>(low)) * (byHour[low + 1] - byHour[low]);
    };
    if (clock.hour <= 6.0 && clock.hour <= -clock.before) return inside(clock.hour);
    if (clock.before >= -6.0) return inside(clock.before);
    const double gap_h = clock.hour - clock.before - 12.0;
    return byHour[12] + (clock.hour - 6.0) / gap_h * (byHour[0] - byHour[12]);
}

/// The clock of a place whose high water comes so much later; a day has tides enough to take the next one for
/// the same.
TidalClock shifted(TidalClock clock, double later_h) {
    const double between_h = clock.hour - clock.before;
    clock.hour -= later_h;
    if (between_h > 0.0) clock.hour -= between_h * std::floor(clock.hour / between_h);
    clock.before = clock.hour - between_h;
    return clock;
}

std::array<NorthEast, 13> readRates(const config::Node& node) {
    config::Reader in(node);
    const std::vector<double> to_deg = in.numbers("to_deg", 13, {0.0, 360.0, "deg"});
    const std::vector<double> rate_kn = in.numbers("rate_kn", 13, {0.0, 20.0, "kn"});
    in.rejectUnknownKeys();
    std::array<NorthEast, 13> rates{};
    if (to_deg.size() != 13 || rate_kn.size() != 13) return rates;
    for (std::size_t i = 0; i < 13; ++i)
        rates[i] = (kKnot_mps * rate_kn[i]) * unitVector(kDegree_rad * to_deg[i]);
    return rates;
}

Streams::Field readField(const config::Node& node) {
    config::Reader in(node);
    config::Reader corner(in.child("southWest"));
    const config::Range place{-2e5, 2e5, "m"};
    const NorthEast southWest{corner.number("north_m", place), corner.number("east_m", place)};
    corner.rejectUnknownKeys();
    const double spacing_m = in.number("spacing_m", {1.0, 20'000.0, "m"});
    const int rows = in.integer("rows", 2, 2000), columns = in.integer("columns", 2, 2000);
    const double unit = in.number("unit", {1e-4, 10.0, "m/s"});
    const auto size = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
    const auto component = [&](const char* key) {
        std::vector<float> values;
        for (const double v : in.numbers(key, size, {-10.0 / unit, 10.0 / unit, "units"}))
            values.push_back(static_cast<float>(v * unit));
        values.resize(size);
        return Grid(southWest, spacing_m, static_cast<std::size_t>(rows), static_cast<std::size_t>(columns),
                    std::move(values));
    };
    Streams::Field field{component("north"), component("east"), {}};
    if (in.has("byHour")) {
        const std::vector<double> values = in.numbers("byHour", 13, {-10.0, 10.0, ""});
        ByHour byHour{};
        if (values.size() == byHour.size()) std::copy(values.begin(), values.end(), byHour.begin());
        field.byHour = byHour;
    }
    in.rejectUnknownKeys();
    return field;
}

}  // namespace

std::vector<HighWater> highWatersOf(const TidePrediction& tide, double longest_s) {
    constexpr double kStep_s = 360.0, kAround_s = 30.0 * kHour_s;
    std::vector<HighWater> found;
    const auto height = [&](double t) { return tide.height_m(SimTime{static_cast<std::int64_t>(t * 1e6)}); };
    double before = height(-kAround_s - kStep_s), now = height(-kAround_s), lowest = now;
    for (double t = -kAround_s; t <= longest_s + kAround_s; t += kStep_s) {
        const double next = height(t + kStep_s);
        lowest = std::min(lowest, now);
        if (now > before && now >= next) {
            if (!found.empty()) found.back().range_m -= lowest;
            const double top = 0.5 * (before - next) / (before - 2.0 * now + next);  // of the parabola
            found.push_back({t + top * kStep_s, now});
            lowest = now;
        }
        before = now;
        now = next;
    }
    if (!found.empty()) found.back().range_m -= lowest;
    return found;
}

TidalClock tidalClockAt(const std::vector<HighWater>& highWaters, SimTime time) {
    if (highWaters.size() < 2) return {};
    const auto later = std::upper_bound(highWaters.begin() + 1, highWaters.end() - 1, time.seconds(),
                                        [](double t, const HighWater& h) { return t < h.time_s; });
    const HighWater& earlier = *(later - 1);
    return {(time.seconds() - earlier.time_s) / kHour_s, (time.seconds() - later->time_s) / kHour_s,
            earlier.range_m};
}

bool Streams::isTidal() const {
    return !tables.empty() ||
           std::any_of(fields.begin(), fields.end(), [](const Field& f) { return f.byHour.has_value(); });
}

NorthEast Streams::at(NorthEast p, const TidalClock& area) const {
    const double later_h = highWater_s / kHour_s;
    const TidalClock clock = shifted(area, later_h);
    for (const Field& field : fields) {
        if (!field.north_mps.covers(p)) continue;
        const double factor = field.byHour ? atHour(*field.byHour, clock) : 1.0;
        return factor * NorthEast{field.north_mps.at(p), field.east_mps.at(p)};
    }
    if (tables.empty()) return {};
    const double springs =
        springRange_m > neapRange_m ? (clock.range_m - neapRange_m) / (springRange_m - neapRange_m) : 1.0;
    const double share = std::clamp(springs, -0.2, 1.2);
    NorthEast sum;
    double weights = 0.0;
    for (const Table& table : tables) {
        const double apart_m = std::max(distance(p, table.at), 1.0), weight = 1.0 / (apart_m * apart_m);
        const NorthEast neap = atHour(table.neaps_mps, clock);
        sum = sum + weight * (neap + share * (atHour(table.springs_mps, clock) - neap));
        weights += weight;
    }
    return (1.0 / weights) * sum;
}

Streams readStreams(config::Reader& in, const LocalFrame& frame) {
    Streams s;
    in.text("source");
    for (const config::Node& node : in.listOr("tables")) {
        config::Reader item(node);
        Streams::Table table;
        table.at = frame.toLocal(item.geoPoint("at"));
        table.springs_mps = readRates(item.child("springs"));
        table.neaps_mps = readRates(item.child("neaps"));
        item.rejectUnknownKeys();
        s.tables.push_back(table);
    }
    for (const config::Node& node : in.listOr("fields")) s.fields.push_back(readField(node));
    if (!s.tables.empty()) {
        s.springRange_m = in.number("springRange_m", {0.05, 20.0, "m"});
        s.neapRange_m = in.number("neapRange_m", {0.0, 20.0, "m"});
    }
    s.highWater_s = 60.0 * in.numberOr("highWaterLater_min", 0.0, {-360.0, 360.0, "min"});
    if (s.empty()) in.problem("tables", "is empty", "a table or a field of streams");
    in.rejectUnknownKeys();
    return s;
}

}  // namespace sagara::core
