#include "ui/debrief/Marks.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "ui/chart/Format.h"
#include "ui/run/RunTexts.h"

namespace sagara::ui {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("sagara::ui::Marks", text); }

MarkKind kindOf(const core::World& world, const core::Event& e) {
    using Kind = core::EventKind;
    switch (e.kind) {
        case Kind::TaskDone:
            return MarkKind::Task;
        case Kind::Deduction:
            return MarkKind::Deduction;
        case Kind::MissionFailed:
            return MarkKind::Failure;
        case Kind::NoteMade:
            return MarkKind::Note;
        case Kind::ScenarioEvent: {
            const auto i = static_cast<std::size_t>(e.index);
            if (i >= world.events.size()) return MarkKind::Event;
            const auto& orders = world.events[i].orders;
            const bool weather = std::any_of(orders.begin(), orders.end(), [](const auto& given) {
                return std::holds_alternative<core::WeatherOrder>(given.order);
            });
            return weather ? MarkKind::Weather : MarkKind::Event;
        }
        default:
            return MarkKind::Event;
    }
}

/// What the deduction was for: "Keep to the speeds: 8 points lost; speed over ground 9.67 kn, limit 6.00".
QString deductionText(const core::World& world, const core::Event& e) {
    const auto i = static_cast<std::size_t>(e.index);
    QString text = eventText(world, e);
    if (i >= world.mission.criteria.size()) return text;
    const core::Display display = world.mission.criteria[i]->display();
    return text + QLatin1String("; ") +
           tr("%1 %2 %3, limit %4")
               .arg(QString::fromUtf8(display.quantity), chart::number(e.value / display.perUnit, 2),
                    QString::fromUtf8(display.unit), chart::number(e.limit / display.perUnit, 2));
}

}  // namespace

QString weatherOrderText(const core::WeatherOrder& order) {
    QStringList parts;
    if (order.windSpeed_mps)
        parts << tr("wind %1 kn").arg(chart::number(*order.windSpeed_mps / core::kKnot_mps, 0));
    if (order.windFrom_rad)
        parts << tr("wind from %1°").arg(chart::bearing(*order.windFrom_rad / core::kDegree_rad));
    if (order.gustiness) parts << tr("gustiness %1").arg(chart::number(*order.gustiness, 2));
    for (const auto& swell : order.swells)
        if (swell) parts << tr("swell %1 m").arg(chart::number(swell->significantHeight_m, 1));
    if (order.current)
        parts << tr("current %1 kn").arg(chart::number(core::length(*order.current) / core::kKnot_mps, 1));
    if (order.visibility_m)
        parts << tr("visibility %1 M").arg(chart::number(*order.visibility_m / core::kNauticalMile_m, 1));
    if (order.rain) parts << tr("rain %1 %").arg(chart::number(100.0 * *order.rain, 0));
    if (parts.isEmpty()) parts << tr("as it was");
    return tr("Weather ordered: %1, over %2 s")
        .arg(parts.join(QStringLiteral(", ")), chart::number(order.ramp_s, 0));
}

const core::TrackSample* sampleAt(const std::vector<core::TrackSample>& track, core::SimTime time) {
    if (track.empty()) return nullptr;
    const auto after = std::partition_point(track.begin(), track.end(), [time](const core::TrackSample& s) {
        return core::timeOfTick(s.tick) <= time;
    });
    return after == track.begin() ? &*after : &*(after - 1);
}

std::vector<DebriefMark> marksOf(const Replay& replay, const std::vector<DebriefNote>& notes) {
    const core::World& world = *replay.world();
    std::vector<DebriefMark> marks;
    const auto add = [&](core::SimTime time, MarkKind kind, const QString& text, double points = 0.0) {
        if (text.isEmpty()) return;
        DebriefMark mark{time, kind, text, points, {}};
        const core::TrackSample* const sample = sampleAt(replay.track(), time);
        if (sample != nullptr && !sample->ships.empty()) mark.place = sample->ships[0].motion.position();
        marks.push_back(std::move(mark));
    };
    for (const core::Event& e : replay.events()) {
        const bool deduction = e.kind == core::EventKind::Deduction;
        add(e.time(), kindOf(world, e),
            deduction ? deductionText(world, e) : eventText(world, replay.added(), e), e.points);
    }
    for (const core::Command& command : replay.commands()) {
        if (const auto* weather = std::get_if<core::WeatherOrder>(&command.order))
            add(core::timeOfTick(command.tick), MarkKind::Weather, weatherOrderText(*weather));
    }
    for (const DebriefNote& note : notes) add(note.time, MarkKind::Note, QString::fromStdString(note.text));
    std::stable_sort(marks.begin(), marks.end(),
                     [](const DebriefMark& a, const DebriefMark& b) { return a.time < b.time; });
    return marks;
}

}  // namespace sagara::ui
