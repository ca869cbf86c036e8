#pragma once

#include <optional>
#include <string>
#include <variant>

#include "core/base/Result.h"
#include "core/vessel/Machinery.h"
#include "ui/input/NmeaSentence.h"

/// What a home-made bridge may order by NMEA 0183; assets/help/input.md lists it for people.
namespace sagara::ui {

struct NmeaRudder {
    double rudder_rad = 0.0;  ///< to starboard is positive
};
/// `engine` as NMEA numbers them: 0 single or on the centre line, odd starboard, even port.
struct NmeaTelegraph {
    int engine = 0;
    core::TelegraphStep step = core::TelegraphStep::Stop;
};
struct NmeaLever {
    int engine = 0;
    double lever = 0.0;  ///< -1 full astern to 1 full ahead
};
struct NmeaThruster {
    double thrust = 0.0;  ///< -1 full to port to 1 full to starboard
    bool atStern = false;
};
struct NmeaHorn {
    bool on = false;
};
struct NmeaLook {
    double yaw_radps = 0.0;
};
struct NmeaAcknowledge {};
struct NmeaBookmark {};
using NmeaOrder = std::variant<NmeaRudder, NmeaTelegraph, NmeaLever, NmeaThruster, NmeaHorn, NmeaLook,
                               NmeaAcknowledge, NmeaBookmark>;

/// Nothing for a sentence that is no order (another kind, an answerback, data marked as not valid); a reason
/// for an order that cannot be understood.
///
///   $--ROR,x.x,A,...             rudder order, starboard or single rudder, degrees, - to port
///   $--HTC,a,x.x,a,M,...         commanded rudder (magnitude, L or R) in manual or rudder-control mode
///   $--ETL,time,O,xx,...,x       engine telegraph order
///   $--PRC,x.x,A,...,x           lever of an engine, -100 to 100 per cent
///   $--TRC,x,x.x,P,...           thruster (odd number at the bow, even at the stern), per cent, - to port
///   $PSGR,HORN,1 | LOOK,x.x | ACK | BOOKMARK    what the standard has no sentence for; LOOK in deg/s
core::Result<std::optional<NmeaOrder>, std::string> orderOf(const NmeaSentence& sentence);

/// Shaft counted from port for an engine's number; kEveryShaft for 0 where no shaft is on the centre line;
/// nothing when there is no such engine.
std::optional<int> shaftOfEngine(int engine, int shafts);
/// The other way round.
int engineOfShaft(int shaft, int shafts);

}  // namespace sagara::ui
