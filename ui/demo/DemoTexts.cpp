#include "ui/demo/DemoTexts.h"

#include <QCoreApplication>
#include <array>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "core/sea/Beaufort.h"
#include "ui/chart/Format.h"

namespace sagara::ui {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("sagara::ui::Demo", text); }
QString name(const std::string& utf8) { return QString::fromStdString(utf8); }

/// The piece of a name that fits a caption: without what stands in brackets.
QString shortName(const std::string& utf8) { return name(utf8).section(QStringLiteral(" ("), 0, 0); }

QString stepText(const core::PilotStep& step, const Hints& hints) {
    if (std::holds_alternative<core::LinesStep>(step)) return tr("The lines are let go");
    if (std::holds_alternative<core::RunStep>(step)) return tr("Rudder and engines work her off the berth");
    if (std::holds_alternative<core::TurnStep>(step))
        return tr("She turns on the spot, one engine ahead, one astern");
    if (std::holds_alternative<core::AnchorStep>(step)) return tr("Going to anchor");
    if (hints.waypoint) return tr("On the way to “%1”").arg(name(hints.waypoint->name));
    return tr("On passage");
}

QString weatherText(const core::Snapshot& now) {
    const int beaufort = core::beaufortOfWind(now.weather.wind.speed_mps);
    const QString wind =
        beaufort == 0 ? tr("calm")
                      : tr("%1 from %2")
                            .arg(tr("Beaufort %1").arg(beaufort), demoCompass(now.weather.wind.windFrom_rad));
    return now.weather.rain > 0.1 ? tr("%1, rain").arg(wind) : wind;
}

}  // namespace

QString demoDistance(double distance_m) {
    const double miles = distance_m / core::kNauticalMile_m;
    if (miles < 0.5) return tr("%1 m").arg(10.0 * std::round(distance_m / 10.0), 0, 'f', 0);
    return tr("%1 sea miles").arg(chart::shortNumber(miles, 1));
}

QString demoCompass(double from_rad) {
    const std::array<QString, 8> names{tr("north"), tr("north-east"), tr("east"), tr("south-east"),
                                       tr("south"), tr("south-west"), tr("west"), tr("north-west")};
    const auto eighth = static_cast<std::size_t>(std::lround(core::wrapTwoPi(from_rad) / (core::kPi / 4.0)));
    return names[eighth % names.size()];
}

QString demoHappening(const core::World& world, const core::State& state, const Hints& hints) {
    if (state.ships.empty()) return {};
    const core::PilotMemory& pilot = state.ships[0].pilot;
    if (state.finished) return tr("The lesson is over");
    if (state.ships[0].aground) return tr("Aground");
    if (pilot.engaged && pilot.step < world.pilot.size()) return stepText(world.pilot[pilot.step], hints);
    if (state.tick == 0 && !world.pilot.empty()) return stepText(world.pilot[0], hints);
    if (hints.waypoint) return tr("On the way to “%1”").arg(name(hints.waypoint->name));
    return tr("Under way");
}

DemoCaption demoCaption(const core::World& world, const core::State& state, const core::Snapshot& now,
                        const Hints& hints) {
    DemoCaption caption;
    caption.title = demoHappening(world, state, hints);
    if (now.ships.empty()) return caption;
    const core::OwnShipView& ship = now.ships[0];
    const double heading_rad =
        ship.motion.heading_rad - world.area.frame.convergence_rad(ship.motion.position());
    caption.figures = {
        {tr("Speed"), tr("%1 kn").arg(core::length(ship.overGround_mps) / core::kKnot_mps, 0, 'f', 1)},
        {tr("Heading"), tr("%1°").arg(chart::bearing(heading_rad / core::kDegree_rad))},
        {tr("Next waypoint"), hints.waypoint ? tr("%1, %2").arg(name(hints.waypoint->name),
                                                                demoDistance(hints.waypoint->distance_m))
                                             : tr("none")},
        {tr("Wind"), weatherText(now)},
        {tr("Visibility"), demoDistance(now.weather.visibility_m)}};
    return caption;
}

QString demoCamera(const core::World& world, const DemoCamera& camera) {
    switch (camera.kind) {
        case DemoCameraKind::Bridge:
            return tr("From her bridge");
        case DemoCameraKind::Chase:
            return tr("From astern");
        case DemoCameraKind::Wing:
            return camera.port ? tr("From the port wing of her bridge")
                               : tr("From the starboard wing of her bridge");
        case DemoCameraKind::Shore:
            return camera.index < world.area.places.size()
                       ? tr("From %1").arg(shortName(world.area.places[camera.index].name))
                       : QString();
        case DemoCameraKind::Target:
            return camera.index < world.targets.size()
                       ? tr("From %1").arg(name(world.targets[camera.index].name))
                       : QString();
    }
    return {};
}

QString demoRudder(double rudder_rad) {
    const auto degrees = std::lround(std::abs(rudder_rad) / core::kDegree_rad);
    if (degrees == 0) return tr("Midships");
    return rudder_rad < 0.0 ? tr("Port %1°").arg(degrees) : tr("Starboard %1°").arg(degrees);
}

QString demoEngine(core::TelegraphStep step) {
    switch (step) {
        case core::TelegraphStep::FullAstern:
            return tr("Full astern");
        case core::TelegraphStep::HalfAstern:
            return tr("Half astern");
        case core::TelegraphStep::SlowAstern:
            return tr("Slow astern");
        case core::TelegraphStep::DeadSlowAstern:
            return tr("Dead slow astern");
        case core::TelegraphStep::Stop:
            return tr("Stop");
        case core::TelegraphStep::DeadSlowAhead:
            return tr("Dead slow ahead");
        case core::TelegraphStep::SlowAhead:
            return tr("Slow ahead");
        case core::TelegraphStep::HalfAhead:
            return tr("Half ahead");
        case core::TelegraphStep::FullAhead:
            return tr("Full ahead");
    }
    return {};
}

QString demoVerdict(DemoScore::Verdict verdict) {
    switch (verdict) {
        case DemoScore::Verdict::TookALook:
            return tr("A short visit to the bridge. Stay a little longer next time!");
        case DemoScore::Verdict::RanAground:
            return tr("She found the bottom. Better here than at sea: watch the depth next time.");
        case DemoScore::Verdict::Touched:
            return tr("She touched something. A ship needs more room than one thinks!");
        case DemoScore::Verdict::LeftTheChannel:
            return tr("You went your own way, safely. Next time try to stay on the route.");
        case DemoScore::Verdict::TooFast:
            return tr("Well steered, but a little fast for the harbour master.");
        case DemoScore::Verdict::Drifted:
            return tr("Safe and sound. A ship steers better with some speed: more engine next time.");
        case DemoScore::Verdict::Good:
            return tr("Well steered! She stayed safe and most of the time on her route.");
        case DemoScore::Verdict::Perfect:
            return tr("Steered like a master: on the route, at a good speed and safe.");
    }
    return {};
}

}  // namespace sagara::ui
