#include "core/vessel/TransferModel.h"

namespace sagara::core {
namespace {

void readYawAndSurge(TransferModel& m, config::Reader& in) {
    m.gain_perS = in.number("gain_perS", {1e-5, 2.0, "1/s"});
    m.timeConstant_s = in.number("timeConstant_s", {0.5, 2000.0, "s"});
    m.referenceSpeed_mps = in.number("referenceSpeed_mps", {0.5, 30.0, "m/s"});
    m.surgeAddedMassRatio = in.number("surgeAddedMassRatio", {0.0, 0.5, ""});
    m.resistance_kgpm = in.number("resistance_kgpm", {1.0, 1e7, "kg/m"});
    m.swayAddedMassRatio = in.number("swayAddedMassRatio", {0.1, 3.0, ""});
    m.yawAddedInertiaRatio = in.number("yawAddedInertiaRatio", {0.1, 3.0, ""});
    m.crossFlowDrag = in.number("crossFlowDrag", {0.0, 3.0, ""});
}

void readSway(TransferModel& m, config::Reader& in, double mostGain_m) {
    m.swayGain_m = in.number("swayGain_m", {-400.0, mostGain_m, "m"});
    m.swayTimeConstant_s = in.number("swayTimeConstant_s", {0.1, 1000.0, "s"});
    m.surgeFromTurn_kg = in.number("surgeFromTurn_kg", {0.0, 1e9, "kg"});
    m.scalesWithSpeed = in.flagOr("scalesWithSpeed", true);
}

/// Sway that comes of loads alone: as quick against yaw as the paper has it.
void withoutSway(TransferModel& m) {
    constexpr double kSwayOverYaw = 0.3;
    m.swayTimeConstant_s = kSwayOverYaw * m.timeConstant_s;
    m.turningLoss = TransferModel::TurningLoss::None;
}

}  // namespace

NomotoModel readNomoto(config::Reader& in) {
    NomotoModel m;
    readYawAndSurge(m, in);
    m.linear = in.numberOr("norrbin1", 1.0, {-1.0, 1.0, ""});
    m.cubic_s2 = in.numberOr("norrbin3_s2", 0.0, {0.0, 1e7, "s2"});
    if (in.sound() && m.linear <= 0.0 && m.cubic_s2 <= 0.0)
        in.problem("norrbin3_s2", "is " + config::formatNumber(m.cubic_s2),
                   "more than 0 where norrbin1 is not: nothing else would end a swing");
    withoutSway(m);
    return m;
}

BarauskisModel readBarauskis(config::Reader& in) {
    BarauskisModel m;
    readYawAndSurge(m, in);
    readSway(m, in, 0.0);
    m.waves = WaveFeeling::Blind;
    return m;
}

UengModel readUeng(config::Reader& in) {
    UengModel m;
    readYawAndSurge(m, in);
    withoutSway(m);
    m.waves = WaveFeeling::Heights;
    return m;
}

SandaruwanModel readSandaruwan(config::Reader& in) {
    SandaruwanModel m;
    readYawAndSurge(m, in);
    const bool printed = in.flagOr("printed", false);
    readSway(m, in, printed ? 400.0 : 0.0);
    if (!printed) return m;
    m.turningLoss = TransferModel::TurningLoss::Printed;
    m.waves = WaveFeeling::HeightsPrinted;
    m.heaveDamping_perm = in.number("heaveDamping_perm", {0.0, 100.0, "1/m"});
    m.pitchDamping_perS = in.number("pitchDamping_perS", {0.0, 100.0, "1/s"});
    m.rollDamping_perS = in.number("rollDamping_perS", {0.0, 100.0, "1/s"});
    return m;
}

}  // namespace sagara::core
