#include "ui/input/NmeaOrders.h"

#include <charconv>
#include <cmath>

#include "core/base/Units.h"
#include "ui/input/ControlMap.h"

namespace sagara::ui {
namespace {

using Answer = core::Result<std::optional<NmeaOrder>, std::string>;

std::optional<double> numberIn(std::string_view text) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (text.empty() || read.ec != std::errc() || read.ptr != end || !std::isfinite(value))
        return std::nullopt;
    return value;
}

Answer none() { return Answer(std::optional<NmeaOrder>()); }
Answer wrong(const NmeaSentence& s, const char* field, std::string_view found, const char* accepted) {
    return s.type + ": " + field + " is \"" + std::string(found) + "\", expected " + accepted;
}
template <typename Order>
Answer order(Order value) {
    return Answer(std::optional<NmeaOrder>(value));
}

std::optional<core::TelegraphStep> stepOf(std::string_view position) {
    using enum core::TelegraphStep;
    struct Row {
        std::string_view code;
        core::TelegraphStep step;
    };
    // 05 is "navigation full" and 15 "crash astern": a telegraph here has no step beyond full.
    constexpr Row kRows[] = {{"00", Stop},           {"01", DeadSlowAhead}, {"02", SlowAhead},
                             {"03", HalfAhead},      {"04", FullAhead},     {"05", FullAhead},
                             {"11", DeadSlowAstern}, {"12", SlowAstern},    {"13", HalfAstern},
                             {"14", FullAstern},     {"15", FullAstern}};
    for (const Row& row : kRows)
        if (row.code == position) return row.step;
    return std::nullopt;
}

/// An engine's number; an empty field is the only engine.
std::optional<int> engineIn(std::string_view text) {
    if (text.empty()) return 0;
    const auto number = numberIn(text);
    if (!number || *number < 0.0 || *number > 99.0 || *number != std::floor(*number)) return std::nullopt;
    return static_cast<int>(*number);
}

Answer rudderOrder(const NmeaSentence& s) {
    if (s.field(1) == "V") return none();
    const auto angle_deg = numberIn(s.field(0));
    if (!angle_deg || std::abs(*angle_deg) > 90.0)
        return wrong(s, "rudder order", s.field(0), "-90 to 90 degrees");
    return order(NmeaRudder{*angle_deg * core::kDegree_rad});
}

Answer headingControl(const NmeaSentence& s) {
    const bool byHand = s.field(0) == "A" || s.field(3) == "M" || s.field(3) == "R";
    if (!byHand || s.field(1).empty()) return none();
    const auto angle_deg = numberIn(s.field(1));
    if (!angle_deg || *angle_deg < 0.0 || *angle_deg > 90.0)
        return wrong(s, "commanded rudder", s.field(1), "0 to 90 degrees");
    if (s.field(2) != "L" && s.field(2) != "R") return wrong(s, "rudder direction", s.field(2), "L or R");
    return order(NmeaRudder{(s.field(2) == "L" ? -*angle_deg : *angle_deg) * core::kDegree_rad});
}

Answer telegraphOrder(const NmeaSentence& s) {
    if (s.field(1) == "A") return none();  // the engine room's answer
    if (s.field(1) != "O") return wrong(s, "message type", s.field(1), "O (order) or A (answerback)");
    const auto step = stepOf(s.field(2));
    if (!step) return wrong(s, "telegraph position", s.field(2), "00 to 05 or 11 to 15");
    const auto engine = engineIn(s.field(5));
    if (!engine) return wrong(s, "engine number", s.field(5), "0 to 99");
    return order(NmeaTelegraph{*engine, *step});
}

Answer leverOrder(const NmeaSentence& s) {
    if (s.field(1) == "V") return none();
    const auto lever_pct = numberIn(s.field(0));
    if (!lever_pct || std::abs(*lever_pct) > 100.0)
        return wrong(s, "lever position", s.field(0), "-100 to 100 per cent");
    const auto engine = engineIn(s.field(7));
    if (!engine) return wrong(s, "engine number", s.field(7), "0 to 99");
    return order(NmeaLever{*engine, 0.01 * *lever_pct});
}

Answer thrusterOrder(const NmeaSentence& s) {
    const auto number = numberIn(s.field(0));
    if (!number || *number < 0.0 || *number > 99.0)
        return wrong(s, "thruster number", s.field(0), "0 to 99, odd at the bow");
    const bool atStern = static_cast<int>(*number) % 2 == 0;
    // A fixed-pitch thruster is ordered by its speed, one of variable pitch by its pitch.
    const bool byPitch = s.field(2) == "V" || s.field(1).empty();
    const std::string_view mode = s.field(byPitch ? 4 : 2);
    if (mode == "V") return none();
    if (mode != "P") return wrong(s, "thruster mode", mode, "P (per cent)");
    const std::string_view text = s.field(byPitch ? 3 : 1);
    const auto demand_pct = numberIn(text);
    if (!demand_pct || std::abs(*demand_pct) > 100.0)
        return wrong(s, "thruster demand", text, "-100 to 100 per cent");
    return order(NmeaThruster{0.01 * *demand_pct, atStern});
}

Answer ownOrder(const NmeaSentence& s) {
    const std::string_view what = s.field(0);
    if (what == "HORN") {
        if (s.field(1) != "0" && s.field(1) != "1") return wrong(s, "HORN", s.field(1), "0 or 1");
        return order(NmeaHorn{s.field(1) == "1"});
    }
    if (what == "LOOK") {
        const auto rate_degps = numberIn(s.field(1));
        if (!rate_degps || std::abs(*rate_degps) > 180.0)
            return wrong(s, "LOOK", s.field(1), "-180 to 180 degrees a second");
        return order(NmeaLook{*rate_degps * core::kDegree_rad});
    }
    if (what == "ACK") return order(NmeaAcknowledge{});
    if (what == "BOOKMARK") return order(NmeaBookmark{});
    return wrong(s, "order", what, "HORN, LOOK, ACK or BOOKMARK");
}

}  // namespace

Answer orderOf(const NmeaSentence& s) {
    if (s.talker == "P") return s.type == "SGR" ? ownOrder(s) : none();
    if (s.type == "ROR") return rudderOrder(s);
    if (s.type == "HTC") return headingControl(s);
    if (s.type == "ETL") return telegraphOrder(s);
    if (s.type == "PRC") return leverOrder(s);
    if (s.type == "TRC") return thrusterOrder(s);
    return none();
}

std::optional<int> shaftOfEngine(int engine, int shafts) {
    const int half = shafts / 2;
    if (engine == 0) return shafts % 2 == 1 ? half : kEveryShaft;
    const int outwards = (engine + 1) / 2;  // first, second ... from the centre line
    if (engine < 0 || outwards > half) {
        // Engine 1 is what a single engine is often called.
        return shafts == 1 && engine == 1 ? std::optional<int>(0) : std::nullopt;
    }
    return engine % 2 == 1 ? shafts - half + outwards - 1 : half - outwards;
}

int engineOfShaft(int shaft, int shafts) {
    const int half = shafts / 2;
    if (shafts % 2 == 1 && shaft == half) return 0;
    return shaft < half ? 2 * (half - shaft) : 2 * (shaft - (shafts - half)) + 1;
}

}  // namespace sagara::ui
