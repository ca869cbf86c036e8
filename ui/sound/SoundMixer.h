#pragma once

#include <array>
#include <optional>

#include "ui/sound/SoundScene.h"
#include "ui/sound/Synthesis.h"

namespace sagara::ui {

/// All voices of a scene: what each sounds like, where it is and how loud. Knows no sound device.
class SoundMixer final {
public:
    enum Source : std::size_t { Engines, Wash, BowWave, Wind, Rain, Horn, Bell, Cable, Alarm, FirstOther };
    static constexpr std::size_t kSources = FirstOther + kMostHeard;

    SoundMixer();

    /// Where a source is. `everywhere`: around the listener, no place.
    struct Placing {
        SoundPlace at;
        bool everywhere = false;
        double fullWithin_m = 20.0;  ///< beyond it half as loud at every doubling
        double gain = 1.0;
    };
    /// Once for every scene, before its blocks: tells which ship is which source.
    void show(const SoundScene& scene);
    Placing placing(std::size_t source) const;
    /// The next block of a source. False when it is silent and stays so until the scene changes.
    bool fill(std::size_t source, Samples out);

private:
    struct OtherVoice {
        std::optional<std::size_t> id;
        SoundScene::Other heard;
        HornVoice horn{71};
        BellVoice bell{BellVoice::Kind::Bell};
        BellVoice gong{BellVoice::Kind::Gong};
    };
    bool wanted(std::size_t source) const;
    void synthesise(std::size_t source, Samples out);
    void fillEngines(Samples out);
    void fillOther(OtherVoice& voice, Samples out);
    void muffle(std::size_t source, Samples out);

    SoundScene m_scene;
    std::array<EngineVoice, 4> m_engines;
    NoiseVoice m_wash, m_bow, m_wind, m_howl, m_rain;
    HornVoice m_horn{17};
    BellVoice m_bell{BellVoice::Kind::Bell};
    CableVoice m_cable{23};
    AlarmVoice m_alarm;
    std::array<OtherVoice, kMostHeard> m_others;
    std::array<Filter, kSources> m_walls;
    Glide m_doors{0.3};
};

/// For devices: 16 bits.
void toInt16(std::span<const float> samples, std::span<std::int16_t> out);

}  // namespace sagara::ui
