#include "ui/run/RunTexts.h"

#include <QCoreApplication>

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
    }
    return {};
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

QString eventText(const core::World& world, const core::Event& e) {
    using Kind = core::EventKind;
    const auto i = static_cast<std::size_t>(e.index);
    const auto& tasks = world.mission.tasks;
    const auto target = [&] { return i < world.targets.size() ? fromStd(world.targets[i].name) : QString(); };
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
        case Kind::AnchorOnBottom:
        case Kind::AnchorHome:
            return {};
    }
    return {};
}

}  // namespace sagara::ui
