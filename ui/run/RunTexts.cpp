#include "ui/run/RunTexts.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/assess/Mission.h"
#include "core/base/Units.h"

namespace sagara::ui {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("sagara::ui::Run", text); }
QString fromStd(const std::string& utf8) { return QString::fromStdString(utf8); }

core::Utc utcAt(const core::World& world, core::SimTime time) {
    return {world.start.unix_s + time.us / 1'000'000};
}

QString faultName(std::int32_t index) {
    switch (static_cast<core::Fault>(index)) {
        case core::Fault::SteeringPump:
            return tr("steering pump");
        case core::Fault::SteeringJam:
            return tr("rudder jammed");
        case core::Fault::Engine:
            return tr("engine");
        case core::Fault::Thruster:
            return tr("thruster");
    }
    return {};
}

QString motionsText(std::uint8_t free) {
    if (free == core::kAllMotions) return tr("All motions free");
    if (free == 0) return tr("All motions held");
    const QStringList names{tr("surge"), tr("sway"), tr("heave"), tr("roll"), tr("pitch"), tr("yaw")};
    QStringList list;
    for (int i = 0; i < names.size(); ++i) {
        if ((free >> i & 1) != 0) list << names[i];
    }
    return tr("Free: %1; the other motions are held").arg(list.join(QStringLiteral(", ")));
}

QString deductionText(const core::World& world, const core::Event& e) {
    const auto& criteria = world.mission.criteria;
    const auto i = static_cast<std::size_t>(e.index);
    if (i >= criteria.size()) return {};
    return tr("%1: %2 points lost").arg(fromStd(criteria[i]->terms().title)).arg(e.points, 0, 'f', 0);
}

}  // namespace

QString elapsed(core::SimTime time) {
    const auto s = time.us / 1'000'000;
    const QString minutes = QStringLiteral("%1:%2")
                                .arg(s / 60 % 60, 2, 10, QLatin1Char('0'))
                                .arg(s % 60, 2, 10, QLatin1Char('0'));
    return s < 3600 ? minutes : QStringLiteral("%1:%2").arg(s / 3600).arg(minutes);
}

QString localTime(const core::World& world, core::SimTime time) {
    return fromStd(core::formatLocal(utcAt(world, time), world.area.utcOffset_min)).mid(11);
}

QString utcTime(const core::World& world, core::SimTime time) {
    return fromStd(core::formatUtc(utcAt(world, time))).mid(11, 8) + QStringLiteral(" UTC");
}

QString reportText(core::ReportKind kind) {
    switch (kind) {
        case core::ReportKind::PortControl:
            return tr("Reported to port control");
        case core::ReportKind::Anchored:
            return tr("Reported: anchored");
        case core::ReportKind::ManOverboard:
            return tr("Reported: man overboard");
    }
    return {};
}

QString eventText(const core::World& world, const core::Event& e) { return eventText(world, {}, e); }

QString eventText(const core::World& world, const std::vector<core::TargetLayout>& added,
                  const core::Event& e) {
    using Kind = core::EventKind;
    const auto i = static_cast<std::size_t>(e.index);
    const auto& tasks = world.mission.tasks;
    const auto target = [&] {
        if (i < world.targets.size()) return fromStd(world.targets[i].name);
        const std::size_t n = i - world.targets.size();
        return n < added.size() ? fromStd(added[n].name) : tr("Added target %1").arg(n + 1);
    };
    const auto line = [&] {
        const auto& ids = world.ships[std::min<std::size_t>(e.ship, world.ships.size() - 1)]->lineIds;
        return i < ids.size() ? fromStd(ids[i]) : QString();
    };
    switch (e.kind) {
        case Kind::TaskDone:
            return i < tasks.size() ? tr("Done: %1").arg(fromStd(tasks[i]->title())) : QString();
        case Kind::Deduction:
            return deductionText(world, e);
        case Kind::MissionFailed:
            return tr("The mission has failed");
        case Kind::Finished:
            return tr("The exercise is over");
        case Kind::LineLetGo:
            return tr("Line let go: %1").arg(line());
        case Kind::LineIn:
            return tr("Line in: %1").arg(line());
        case Kind::LineParted:
            return tr("Line parted: %1").arg(line());
        case Kind::AnchorLetGo:
            return tr("Anchor let go");
        case Kind::AnchorDragging:
            return tr("Anchor drags");
        case Kind::CableParted:
            return tr("Anchor cable parted");
        case Kind::Contact:
            return tr("Contact: %1").arg(fromStd(core::contactKindName(e.contact)));
        case Kind::Grounding:
            return tr("Aground");
        case Kind::Afloat:
            return tr("Afloat again");
        case Kind::ScenarioEvent:
            return i < world.events.size() ? fromStd(world.events[i].title) : QString();
        case Kind::FaultCame:
            return tr("Fault: %1").arg(faultName(e.index));
        case Kind::FaultMended:
            return tr("Mended: %1").arg(faultName(e.index));
        case Kind::TargetAppeared:
            return tr("%1 appears").arg(target());
        case Kind::TargetGone:
            return tr("%1 is gone").arg(target());
        case Kind::LevelChanged:
            return tr("Difficulty %1").arg(e.index);
        case Kind::Stopped:
            return tr("Stopped: a value of the simulation was not a number");
        case Kind::NoteMade:
            if (e.text.empty()) return tr("Bookmark");
            return (e.value > 0.0 ? tr("Bookmark: %1") : tr("Note: %1")).arg(fromStd(e.text));
        case Kind::Reported:
            return reportText(static_cast<core::ReportKind>(e.index));
        case Kind::TargetMoved:
            return tr("%1 is put elsewhere").arg(target());
        case Kind::MotionsFreed:
            return motionsText(static_cast<std::uint8_t>(e.index));
        case Kind::GreenWater:
            return tr("Green water over the bow, %1 m").arg(e.value, 0, 'f', 1);
        case Kind::Slam:
            return tr("The bow slams, %1 m/s").arg(e.value, 0, 'f', 1);
        case Kind::AnchorOnBottom:
        case Kind::AnchorHome:
            return {};
    }
    return {};
}

}  // namespace sagara::ui
