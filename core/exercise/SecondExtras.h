#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/exercise/State.h"

namespace sagara::core {

/// What most seconds of a recording do not have: texts of events and targets that the trainer has added. It
/// stands at the end of a second's chunk and is left out when it is empty, as it was before there was any.
struct SecondExtras {
    struct Text {
        std::uint32_t event = 0;  ///< index among the events of the second
        std::string text;
        template <typename Archive, typename Self>
        static void fields(Archive& ar, Self& self) {
            ar(self.event, self.text);
        }
    };
    /// One added target in one track sample; rounded to 1 dm, 0.001 rad and 1 cm/s like the others.
    struct Sample {
        std::uint32_t sample = 0;  ///< index among the samples of the second
        std::uint8_t target = 0;   ///< index among the added
        std::int32_t north_dm = 0;
        std::int32_t east_dm = 0;
        std::int16_t heading_mrad = 0;
        std::uint16_t speed_cmps = 0;
        template <typename Archive, typename Self>
        static void fields(Archive& ar, Self& self) {
            ar(self.sample, self.target, self.north_dm, self.east_dm, self.heading_mrad, self.speed_cmps);
        }
    };
    std::vector<Text> texts;
    std::vector<TargetLayout> added;  ///< in this second
    std::vector<Sample> samples;

    bool empty() const { return texts.empty() && added.empty() && samples.empty(); }

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.texts, self.added, self.samples);
    }
};

/// The added targets that are there, as samples of the track sample numbered `sample`.
void sampleAdded(const World& world, const State& state, std::uint32_t sample,
                 std::vector<SecondExtras::Sample>& out);

}  // namespace sagara::core
