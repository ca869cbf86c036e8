#include "ui/input/NmeaSentence.h"

#include <array>
#include <charconv>

namespace sagara::ui {

const char* faultText(NmeaFault fault) {
    switch (fault) {
        case NmeaFault::NotASentence:
            return "does not begin with $ and a name";
        case NmeaFault::TooLong:
            return "longer than 120 characters";
        case NmeaFault::NotText:
            return "holds bytes that are not printable ASCII";
        case NmeaFault::NoChecksum:
            return "has no checksum (*hh at the end)";
        case NmeaFault::WrongChecksum:
            return "checksum is wrong";
    }
    return "";
}

std::uint8_t checksumOf(std::string_view between) {
    std::uint8_t sum = 0;
    for (const char c : between) sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
    return sum;
}

std::string withChecksum(std::string_view body) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    const std::uint8_t sum = checksumOf(body);
    std::string text = "$";
    text.append(body);
    text += '*';
    text += kDigits[sum >> 4U];
    text += kDigits[sum & 15U];
    return text;
}

core::Result<NmeaSentence, NmeaFault> parseSentence(std::string_view line) {
    if (line.size() > kLongestSentence) return NmeaFault::TooLong;
    for (const char c : line)
        if (c < ' ' || c > '~') return NmeaFault::NotText;
    if (line.size() < 4 || (line[0] != '$' && line[0] != '!')) return NmeaFault::NotASentence;
    const std::size_t star = line.rfind('*');
    if (star == std::string_view::npos || line.size() < star + 3) return NmeaFault::NoChecksum;
    const std::string_view body = line.substr(1, star - 1);
    unsigned said = 0;
    const char* const end = line.data() + star + 3;
    if (std::from_chars(line.data() + star + 1, end, said, 16).ptr != end) return NmeaFault::NoChecksum;
    if (said != checksumOf(body)) return NmeaFault::WrongChecksum;

    std::vector<std::string> parts;
    std::size_t from = 0;
    for (std::size_t comma = body.find(','); comma != std::string_view::npos; comma = body.find(',', from)) {
        parts.emplace_back(body.substr(from, comma - from));
        from = comma + 1;
    }
    parts.emplace_back(body.substr(from));
    const std::string name = parts.front();
    if (name.size() < 4) return NmeaFault::NotASentence;
    NmeaSentence sentence;
    const std::size_t talker = name[0] == 'P' ? 1 : 2;
    sentence.talker = name.substr(0, talker);
    sentence.type = name.substr(talker);
    sentence.fields.assign(parts.begin() + 1, parts.end());
    return sentence;
}

std::vector<std::string> NmeaLines::feed(std::string_view bytes) {
    std::vector<std::string> lines;
    for (const char c : bytes) {
        if (c == '\r' || c == '\n') {
            if (!m_line.empty()) lines.push_back(std::move(m_line));
            m_line.clear();
            m_skipping = false;
        } else if (!m_skipping) {
            m_line += c;
            if (m_line.size() > kLongestSentence) {
                lines.push_back(std::move(m_line));
                m_line.clear();
                m_skipping = true;  // the rest of this line is no sentence of its own
            }
        }
    }
    return lines;
}

}  // namespace sagara::ui
