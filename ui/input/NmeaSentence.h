#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

/// NMEA 0183 on the wire: lines of text, "$IIROR,-10.0,A,,V,B*3F".
namespace sagara::ui {

struct NmeaSentence {
    std::string talker;  ///< "II"; "P" for proprietary ones
    std::string type;    ///< "ROR"; for proprietary ones all after the P: "SGR"
    std::vector<std::string> fields;

    /// Empty for one that is not there.
    std::string_view field(std::size_t index) const {
        return index < fields.size() ? std::string_view(fields[index]) : std::string_view();
    }
};

enum class NmeaFault { NotASentence, TooLong, NotText, NoChecksum, WrongChecksum };
const char* faultText(NmeaFault fault);

/// The standard says 82; some gateways send more.
inline constexpr std::size_t kLongestSentence = 120;

std::uint8_t checksumOf(std::string_view between);  ///< of what stands between $ and *
/// Total: any bytes give a sentence or a reason. The checksum must be there and right: orders to a rudder are
/// not guessed.
core::Result<NmeaSentence, NmeaFault> parseSentence(std::string_view line);
/// "$" + body + "*hh", without the end of the line.
std::string withChecksum(std::string_view body);

/// Cuts a stream of bytes into lines; never holds more than one sentence.
class NmeaLines final {
public:
    /// Whole lines without their ends. A line that grows too long comes out cut, so that it is counted as
    /// TooLong.
    std::vector<std::string> feed(std::string_view bytes);

private:
    std::string m_line;
    bool m_skipping = false;
};

}  // namespace sagara::ui
