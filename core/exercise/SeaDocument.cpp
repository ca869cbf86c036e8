#include "core/exercise/SeaDocument.h"

#include "core/base/Angle.h"
#include "core/sea/Beaufort.h"
#include "core/sea/BuoySpectrum.h"
#include "core/sea/SeaOrder.h"

namespace sagara::core {
namespace {

enum class Kind { PiersonMoskowitz, Bretschneider, Ittc, Jonswap, OchiHubble, Beaufort, Measured };

std::vector<SeaSystem> readBeaufort(config::Reader& in, const SeaOrder& order) {
    const int number = in.integer("number", 0, kBeaufortMax);
    const auto exposure =
        in.choice<Exposure>("exposure", {{"inshore", Exposure::Inshore}, {"ocean", Exposure::Ocean}});
    const auto sea = windSea(windOfBeaufort_mps(number), order.wavesTo_rad + kPi, exposure);
    if (!sea) return {};
    SeaSystem system(*sea);
    system.spreading = order.spreading;
    system.law = order.law;
    return {system};
}

}  // namespace

std::vector<SeaSystem> readSea(config::Reader& in) {
    const Kind kind = in.choice<Kind>("spectrum", {{"pierson-moskowitz", Kind::PiersonMoskowitz},
                                                   {"bretschneider", Kind::Bretschneider},
                                                   {"ittc", Kind::Ittc},
                                                   {"jonswap", Kind::Jonswap},
                                                   {"ochi-hubble", Kind::OchiHubble},
                                                   {"beaufort", Kind::Beaufort},
                                                   {"measured", Kind::Measured}});
    std::vector<SeaSystem> systems;
    if (kind == Kind::Measured) {
        config::Reader record(in.child("record"));
        systems = readBuoySpectrum(record).systems();
        in.rejectUnknownKeys();
        return systems;
    }
    SeaOrder order;
    if (kind < Kind::Beaufort) order.spectrum = static_cast<SeaSpectrum>(kind);
    if (kind == Kind::PiersonMoskowitz) order.wind_mps = kKnot_mps * in.number("wind_kn", {0.5, 120.0, "kn"});
    if (kind != Kind::PiersonMoskowitz && kind != Kind::Beaufort)
        order.significantHeight_m = in.number("height_m", {0.0, 20.0, "m"});
    if (kind == Kind::Bretschneider || kind == Kind::Jonswap)
        order.peakPeriod_s = in.number("period_s", {1.0, 25.0, "s"});
    if (kind == Kind::Ittc) order.meanPeriod_s = in.number("meanPeriod_s", {1.0, 20.0, "s"});
    if (kind == Kind::Jonswap) order.gamma = in.numberOr("gamma", 3.3, {1.0, 7.0, ""});
    order.wavesTo_rad = wrapTwoPi(kDegree_rad * in.number("from_deg", {0.0, 360.0, "deg"}) + kPi);
    order.spreading = in.numberOr("spreading", 4.0, {1.0, 100.0, ""});
    if (in.has("spreadingLaw"))
        order.law = in.choice<SpreadingLaw>("spreadingLaw",
                                            {{"cos2s", SpreadingLaw::Cos2s}, {"cosN", SpreadingLaw::CosN}});
    systems = kind == Kind::Beaufort ? readBeaufort(in, order) : systemsOf(order);
    in.rejectUnknownKeys();
    return systems;
}

}  // namespace sagara::core
