#include "ui/input/ControlMap.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <array>

namespace sagara::ui {
namespace {

constexpr std::array<const char*, kBridgeActions> kActionNames{"none",
                                                               "horn",
                                                               "telegraphUp",
                                                               "telegraphDown",
                                                               "stopEngines",
                                                               "rudderPort",
                                                               "rudderStarboard",
                                                               "rudderPortFine",
                                                               "rudderStarboardFine",
                                                               "midships",
                                                               "thrusterPort",
                                                               "thrusterStarboard",
                                                               "thrusterStop",
                                                               "lookLeft",
                                                               "lookRight",
                                                               "acknowledge",
                                                               "bookmark",
                                                               "sternThrusterPort",
                                                               "sternThrusterStarboard",
                                                               "sternThrusterStop",
                                                               "pitchAstern",
                                                               "pitchAhead",
                                                               "azimuthPort",
                                                               "azimuthStarboard"};
constexpr std::array<const char*, std::size(kAxisUses)> kAxisNames{
    "none", "rudder", "telegraph", "thruster", "look", "sternThruster", "pitch", "azimuth"};

QString tr(const char* text) { return QCoreApplication::translate("ControlMap", text); }

int shaftIn(const QJsonObject& in) {
    const int shaft = in[QStringLiteral("shaft")].toInt(kEveryShaft);
    return shaft >= 0 && shaft < kMostMappedShafts ? shaft : kEveryShaft;
}

AxisMap axisIn(const QJsonObject& in) {
    AxisMap axis;
    const std::string use = in[QStringLiteral("use")].toString().toStdString();
    for (std::size_t i = 0; i < kAxisNames.size(); ++i)
        if (use == kAxisNames[i]) axis.use = kAxisUses[i];
    axis.shaft = shaftIn(in);
    AxisCalibration read;
    read.least = in[QStringLiteral("least")].toDouble(-1.0);
    read.centre = in[QStringLiteral("centre")].toDouble(0.0);
    read.most = in[QStringLiteral("most")].toDouble(1.0);
    read.deadZone = in[QStringLiteral("deadZone")].toDouble(read.deadZone);
    read.inverted = in[QStringLiteral("inverted")].toBool();
    if (usable(read)) axis.calibration = read;
    return axis;
}

}  // namespace

QString axisUseText(AxisUse use) {
    switch (use) {
        case AxisUse::None:
            return tr("nothing");
        case AxisUse::Rudder:
            return tr("Rudder");
        case AxisUse::Telegraph:
            return tr("Telegraph");
        case AxisUse::Thruster:
            return tr("Bow thruster");
        case AxisUse::Look:
            return tr("Look around");
        case AxisUse::SternThruster:
            return tr("Stern thruster");
        case AxisUse::Pitch:
            return tr("Pitch");
        case AxisUse::Azimuth:
            return tr("Azimuth drive");
    }
    return {};
}

bool needsShaft(AxisUse use) {
    return use == AxisUse::Telegraph || use == AxisUse::Pitch || use == AxisUse::Azimuth;
}

QString actionText(BridgeAction action) {
    switch (action) {
        case BridgeAction::None:
            return tr("nothing");
        case BridgeAction::Horn:
            return tr("Horn");
        case BridgeAction::TelegraphUp:
            return tr("Telegraph up one step");
        case BridgeAction::TelegraphDown:
            return tr("Telegraph down one step");
        case BridgeAction::StopEngines:
            return tr("Stop engines");
        case BridgeAction::RudderPort:
            return tr("Rudder 5° to port");
        case BridgeAction::RudderStarboard:
            return tr("Rudder 5° to starboard");
        case BridgeAction::RudderPortFine:
            return tr("Rudder 1° to port");
        case BridgeAction::RudderStarboardFine:
            return tr("Rudder 1° to starboard");
        case BridgeAction::Midships:
            return tr("Rudder midships");
        case BridgeAction::ThrusterPort:
            return tr("Bow thruster to port");
        case BridgeAction::ThrusterStarboard:
            return tr("Bow thruster to starboard");
        case BridgeAction::ThrusterStop:
            return tr("Bow thruster stop");
        case BridgeAction::LookLeft:
            return tr("Look left");
        case BridgeAction::LookRight:
            return tr("Look right");
        case BridgeAction::Acknowledge:
            return tr("Acknowledge alarm");
        case BridgeAction::Bookmark:
            return tr("Bookmark");
        case BridgeAction::SternThrusterPort:
            return tr("Stern thruster to port");
        case BridgeAction::SternThrusterStarboard:
            return tr("Stern thruster to starboard");
        case BridgeAction::SternThrusterStop:
            return tr("Stern thruster stop");
        case BridgeAction::PitchAstern:
            return tr("Pitch 10 % astern");
        case BridgeAction::PitchAhead:
            return tr("Pitch 10 % ahead");
        case BridgeAction::AzimuthPort:
            return tr("Azimuth drive 15° to port");
        case BridgeAction::AzimuthStarboard:
            return tr("Azimuth drive 15° to starboard");
    }
    return {};
}

const char* actionName(BridgeAction action) { return kActionNames[static_cast<std::size_t>(action)]; }

std::optional<BridgeAction> actionByName(std::string_view name) {
    for (std::size_t i = 0; i < kActionNames.size(); ++i)
        if (name == kActionNames[i]) return static_cast<BridgeAction>(i);
    return std::nullopt;
}

bool needsShaft(BridgeAction action) {
    return action == BridgeAction::TelegraphUp || action == BridgeAction::TelegraphDown ||
           action == BridgeAction::StopEngines || action >= BridgeAction::PitchAstern;
}

ControlMap usualMap(int axes, int buttons, int hats) {
    ControlMap map = fitted({}, axes, buttons + 4 * hats);
    if (axes > 0) map.axes[0].use = AxisUse::Rudder;
    if (buttons > 0) map.buttons[0].action = BridgeAction::Horn;
    if (buttons > 1) map.buttons[1].action = BridgeAction::Acknowledge;
    if (hats == 0) return map;
    const auto hat = static_cast<std::size_t>(buttons);
    map.buttons[hat].action = BridgeAction::TelegraphUp;
    map.buttons[hat + 1].action = BridgeAction::LookRight;
    map.buttons[hat + 2].action = BridgeAction::TelegraphDown;
    map.buttons[hat + 3].action = BridgeAction::LookLeft;
    return map;
}

ControlMap fitted(ControlMap map, int axes, int buttons) {
    map.axes.resize(static_cast<std::size_t>(std::max(0, axes)));
    map.buttons.resize(static_cast<std::size_t>(std::max(0, buttons)));
    return map;
}

std::string textOf(const ControlMap& map) {
    QJsonArray axes;
    for (const AxisMap& axis : map.axes) {
        const AxisCalibration& c = axis.calibration;
        axes.append(QJsonObject{
            {QStringLiteral("use"), QString::fromLatin1(kAxisNames[static_cast<std::size_t>(axis.use)])},
            {QStringLiteral("shaft"), axis.shaft},
            {QStringLiteral("least"), c.least},
            {QStringLiteral("centre"), c.centre},
            {QStringLiteral("most"), c.most},
            {QStringLiteral("deadZone"), c.deadZone},
            {QStringLiteral("inverted"), c.inverted}});
    }
    QJsonArray buttons;
    for (const ButtonMap& button : map.buttons)
        buttons.append(QJsonObject{{QStringLiteral("action"), QString::fromLatin1(actionName(button.action))},
                                   {QStringLiteral("shaft"), button.shaft}});
    const QJsonObject all{{QStringLiteral("axes"), axes}, {QStringLiteral("buttons"), buttons}};
    return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

std::optional<ControlMap> controlMapOf(std::string_view text) {
    const QJsonDocument document =
        QJsonDocument::fromJson(QByteArray(text.data(), static_cast<qsizetype>(text.size())));
    if (!document.isObject()) return std::nullopt;
    const QJsonObject all = document.object();
    if (!all[QStringLiteral("axes")].isArray() || !all[QStringLiteral("buttons")].isArray())
        return std::nullopt;
    ControlMap map;
    const QJsonArray axes = all[QStringLiteral("axes")].toArray();
    const QJsonArray buttons = all[QStringLiteral("buttons")].toArray();
    for (const QJsonValue value : axes) map.axes.push_back(axisIn(value.toObject()));
    for (const QJsonValue value : buttons) {
        const QJsonObject in = value.toObject();
        const auto action = actionByName(in[QStringLiteral("action")].toString().toStdString());
        map.buttons.push_back({action.value_or(BridgeAction::None), shaftIn(in)});
    }
    return map;
}

}  // namespace sagara::ui
