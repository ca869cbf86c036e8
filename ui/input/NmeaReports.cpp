#include "ui/input/NmeaReports.h"

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <ctime>

#include "core/base/Angle.h"
#include "ui/input/NmeaOrders.h"
#include "ui/input/NmeaSentence.h"

namespace sagara::ui {
namespace {

constexpr double kFoot_m = 0.3048;
constexpr double kFathom_m = 1.8288;

[[gnu::format(printf, 1, 2)]] std::string sentence(const char* format, ...) {
    std::array<char, kLongestSentence> text{};
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text.data(), text.size(), format, arguments);
    va_end(arguments);
    return withChecksum(text.data());
}

/// Rounded first, so that 359.96 is 0.0 and not 360.0.
double degrees(double angle_rad) {
    const double tenths = std::round(core::wrapTwoPi(angle_rad) / core::kDegree_rad * 10.0);
    return std::fmod(tenths, 3600.0) / 10.0;
}

/// "0601.9500,N,08013.6000,E"
std::string placeText(core::GeoPoint p) {
    const auto part = [](double value_deg, int width, char positive, char negative) {
        const long tenThousandths = std::lround(std::abs(value_deg) * 600'000.0);
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%0*ld%02ld.%04ld,%c", width, tenThousandths / 600'000,
                      tenThousandths / 10'000 % 60, tenThousandths % 10'000,
                      value_deg < 0.0 ? negative : positive);
        return std::string(text.data());
    };
    return part(p.lat_deg, 2, 'N', 'S') + "," + part(p.lon_deg, 3, 'E', 'W');
}

}  // namespace

ApparentWind apparentWind(const core::WindVelocity& wind, const core::OwnShipView& ship) {
    const core::NorthEast blows = -wind.speed_mps * core::unitVector(wind.windFrom_rad);
    const core::NorthEast felt = blows - ship.overGround_mps;
    const double speed_mps = core::length(felt);
    if (speed_mps < 1e-6) return {};
    const double from_rad = std::atan2(-felt.east_m, -felt.north_m);
    return {core::wrapTwoPi(from_rad - ship.motion.heading_rad), speed_mps};
}

std::vector<std::string> nmeaReports(const core::World& world, const core::Snapshot& now, std::size_t index) {
    if (index >= now.ships.size()) return {};
    const core::OwnShipView& ship = now.ships[index];
    const core::OwnShip& particulars = *world.ships[index];
    const core::NorthEast position = ship.motion.position();
    const double convergence_rad = world.area.frame.convergence_rad(position);
    const double heading_deg = degrees(ship.motion.heading_rad - convergence_rad);
    const double water_mps = ship.motion.surge_mps;
    const double ground_mps = core::length(ship.overGround_mps);
    const double course_deg = degrees(core::bearing_rad({}, ship.overGround_mps) - convergence_rad);
    const double limit_mps = 1e-3;  // standing still has no course

    const auto seconds = static_cast<std::int64_t>(std::floor(now.time().seconds()));
    const auto hundredths = (now.time().us / 10'000) % 100;
    const std::time_t instant = static_cast<std::time_t>(world.start.unix_s + seconds);
    std::tm utc{};
    gmtime_r(&instant, &utc);
    std::array<char, 32> clock{};
    std::snprintf(clock.data(), clock.size(), "%02d%02d%02d.%02d", utc.tm_hour, utc.tm_min, utc.tm_sec,
                  static_cast<int>(hundredths));
    const std::string place = placeText(world.area.frame.toGeo(position));

    std::vector<std::string> out;
    out.push_back(sentence("IIHDT,%.1f,T", heading_deg));
    out.push_back(sentence("IIROT,%.1f,A", ship.motion.yawRate_radps / core::kDegree_rad * 60.0));
    out.push_back(
        sentence("IIVHW,%.1f,T,,M,%.2f,N,%.2f,K", heading_deg, water_mps / core::kKnot_mps, water_mps * 3.6));
    if (ground_mps > limit_mps)
        out.push_back(sentence("GPVTG,%.1f,T,,M,%.2f,N,%.2f,K,A", course_deg, ground_mps / core::kKnot_mps,
                               ground_mps * 3.6));
    else
        out.push_back(sentence("GPVTG,,T,,M,0.00,N,0.00,K,A"));
    out.push_back(sentence("GPGGA,%s,%s,1,10,0.9,%.1f,M,,M,,", clock.data(), place.c_str(),
                           particulars.vessel.bridgeEyeHeight_m));
    out.push_back(sentence("GPGLL,%s,%s,A,A", place.c_str(), clock.data()));
    out.push_back(sentence("GPZDA,%s,%02d,%02d,%04d,00,00", clock.data(), utc.tm_mday, utc.tm_mon + 1,
                           utc.tm_year + 1900));
    const double depth_m = std::max(0.0, ship.underKeel_m);
    out.push_back(sentence("IIDBT,%.1f,f,%.1f,M,%.1f,F", depth_m / kFoot_m, depth_m, depth_m / kFathom_m));
    out.push_back(sentence("IIDPT,%.1f,%.1f", depth_m, particulars.vessel.hull.draught_m));
    const ApparentWind felt = apparentWind(now.wind, ship);
    out.push_back(
        sentence("IIMWV,%.1f,R,%.1f,N,A", degrees(felt.from_rad), felt.speed_mps / core::kKnot_mps));
    out.push_back(sentence("IIMWV,%.1f,T,%.1f,N,A", degrees(now.wind.windFrom_rad - ship.motion.heading_rad),
                           now.wind.speed_mps / core::kKnot_mps));
    out.push_back(sentence("IIRSA,%.1f,A,,V", ship.rudder_rad / core::kDegree_rad));
    const int shafts = static_cast<int>(ship.shafts_rps.size());
    for (int i = 0; i < shafts; ++i)
        out.push_back(sentence("IIRPM,S,%d,%.1f,,A", engineOfShaft(i, shafts),
                               ship.shafts_rps[static_cast<std::size_t>(i)] * 60.0));
    // Numbered as the standard does: odd at the bow, even at the stern, each from 1 or 2 up.
    int bow = 1, stern = 2;
    for (std::size_t i = 0; i < ship.thrusters.size(); ++i) {
        int& next = particulars.vessel.thrusters.units[i].position.x_m > 0.0 ? bow : stern;
        out.push_back(sentence("IITRD,%d,%.1f,P,,V,", next, 100.0 * ship.thrusters[i].share));
        next += 2;
    }
    return out;
}

}  // namespace sagara::ui
